// An application in inches: its data and the texts of the page are in inches, the arm and the picture are where they
// are in the same application in mm.
const assert = require("node:assert/strict");
const { readFileSync, writeFileSync } = require("node:fs");
const { join } = require("node:path");
const { test } = require("node:test");
const { isAt, jogTo, served, setProgram } = require("./served.js");

const APPLICATION = "usr/usrapp/palletiser/palletiser";

const MANUAL = [0, 30, 90, 0, 45, 20];

/** The program moves to a point that was taught while it waited for a signal. */
const CODE = `
  wait(io:diPart)
  movej(pPick,tGripper,mFast)
  waitEndMove()
  wait(false)`;

function edit(folder, extension, change) {
  const file = join(folder, `${APPLICATION}.${extension}`);
  writeFileSync(file, change(readFileSync(file, "latin1")), "latin1");
}

/** Converts the application and its lengths to inches. */
function toInches(folder) {
  setProgram(folder, CODE);
  edit(folder, "pjx", (text) => text.replace('millimeterUnit="true"', 'millimeterUnit="false"'));
  edit(folder, "dtx", (text) => text.replace(/ (x|y|z|leave|reach)="([^"]+)"/g, (_, name, length) => ` ${name}="${Number(length) / 25.4}"`));
}

/** Returns the poses of all points, frames and tools, in mm and degrees. */
const poses = (page) => page.evaluate(() => {
  const { points, frames, tools } = window.val3View.store.panels.cell;
  return [points, frames, tools].flatMap(({ value }) => value.map(({ pose }) => pose));
});

const joints = (page) => page.evaluate(() => window.val3View.store.panels.cell.sample.value.joints);

async function toManual(page) {
  await page.getByLabel(/mode/i).first().selectOption("manual");
  await page.getByRole("button", { name: "Switch power on" }).click();
  await page.getByRole("button", { name: "Switch power off" }).waitFor();
}

test("the picture of an application in inches is that of the same application in mm", async () => {
  const found = [];
  for (const prepare of [(folder) => setProgram(folder, CODE), toInches]) {
    await served([], async (run) => found.push(await poses(await run.open())), prepare);
  }
  const [millimetres, inches] = found;
  assert.ok(millimetres.length >= 10 && millimetres.length === inches.length, `${millimetres.length} and ${inches.length} values`);
  millimetres.flat().forEach((part, index) => assert.ok(Math.abs(part - inches.flat()[index]) < 1e-6, `value ${Math.floor(index / 6)}: ${part} and ${inches.flat()[index]}`));
});

test("positions are read, jogged and entered in inches", () => served([], async (run) => {
  const page = await run.open();
  await toManual(page);
  await jogTo(page, MANUAL);
  const readout = page.locator("dl.position");
  await readout.getByText("inches").waitFor();
  const pose = await page.evaluate(() => window.val3View.pose());
  await page.waitForFunction((x) => document.querySelector("dl.position dd").textContent === x, (pose[0] / 25.4).toFixed(3));

  await page.getByRole("combobox", { name: /^Along/ }).selectOption("world");
  await page.getByRole("combobox", { name: /^Step/ }).selectOption({ label: "0.2 in, 5°" });
  await page.getByRole("button", { name: "X plus", exact: true }).focus();
  await page.keyboard.press("Enter");
  await page.waitForFunction((x) => Math.abs(window.val3View.pose()[0] - x - 5.08) < 0.02, pose[0]);

  await page.getByRole("tab", { name: "Points" }).click();
  await page.getByRole("button", { name: "pPick", exact: true }).click();
  const x = page.getByRole("form", { name: "Values of pPick" }).getByLabel("x (in)", { exact: true });
  assert.equal(await x.inputValue(), "5.9055");
  const [before] = await page.evaluate(() => window.val3View.store.panels.cell.points.value.filter(({ name }) => name === "pPick"));
  await x.fill("6,9055");
  await page.getByRole("button", { name: "Apply" }).click();
  await page.waitForFunction(([x, y]) => {
    const { pose } = window.val3View.store.panels.cell.points.value.find(({ name }) => name === "pPick");
    return Math.abs(Math.hypot(pose[0] - x, pose[1] - y) - 25.4) < 1e-3;
  }, before.pose);
  await x.fill("4000");
  await page.getByRole("button", { name: "Apply" }).click();
  await page.getByText("x is 4000, outside the range from -3937 to 3937 inches").waitFor();
}, toInches));

test("a program in inches moves to a taught point without a change of the joints", () => served([], async (run) => {
  const page = await run.open();
  await toManual(page);
  await jogTo(page, MANUAL);
  const taught = await joints(page);
  await page.getByRole("tab", { name: "Points" }).click();
  await page.getByRole("combobox", { name: /^Tool/ }).selectOption("tGripper");
  await page.getByRole("button", { name: "pPick", exact: true }).click();
  await page.getByRole("button", { name: /^Teach here: tool tGripper/ }).click();
  await page.getByText(/\(movej\): 0\.0 {2}30\.0 {2}90\.0 {2}0\.0 {2}45\.0 {2}20\.0$/).waitFor();

  await jogTo(page, [0, 20, 90, 0, 60, 0]);
  await page.getByRole("button", { name: "Save to .dtx (1)" }).click();
  await page.getByText("Saved palletiser.dtx.").waitFor();
  assert.match(readFileSync(join(run.folder, `${APPLICATION}.dtx`), "latin1"), /name="pPick"[^>]*>\s*<Value key="0" x="-?\d\.|name="pPick"[^>]*>\s*<Value key="0" x="-?\d\d\./);
  const operate = (keys) => page.evaluate((keys) => window.val3View.store.command("operate", { keys }), keys);
  await operate({ mode: "local" });
  await operate({ power: true });
  await operate({ move: true });
  await page.getByRole("tab", { name: "Inputs and outputs" }).click();
  await page.getByRole("searchbox").fill("diPart");
  await page.getByRole("button", { name: / is / }).first().click();
  await isAt(page, taught, 1e-3);
}, toInches));
