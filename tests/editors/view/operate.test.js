// The palletiser is operated in a browser: keys, signals, points, and the recording of a run.
const assert = require("node:assert/strict");
const { readFileSync, writeFileSync } = require("node:fs");
const { join } = require("node:path");
const { test } = require("node:test");
const { BOXES, openFile, served, until } = require("./served.js");

const POINTS = "usr/usrapp/palletiser/palletiser.dtx";

const state = (page) => page.evaluate(() => window.val3View.store.panels.cell.state.value);

test("typed keys and forced inputs let the program continue", () => served([], async (run) => {
  const page = await run.open();
  await page.getByRole("button", { name: "Power off" }).click();
  await page.getByRole("button", { name: "Power on" }).waitFor();
  await page.getByRole("application").focus();
  await page.keyboard.press("F1");
  await page.getByText("State    running").waitFor();
  assert.equal((await state(page)).queue.length, 0);
  const still = await page.evaluate(() => window.val3View.pose());
  await page.getByRole("tab", { name: "Inputs and outputs" }).click();
  for (const input of ["I0", "I4", "I5"]) {
    await page.getByRole("searchbox").fill(`%${input}`);
    await page.getByRole("button", { name: `%${input} is` }).first().click();
    await page.waitForFunction((input) => window.val3View.store.panels.cell.levels.value.get(`BasicIO-1\\%${input}`)?.value === 1, input);
  }
  await page.waitForFunction((still) => window.val3View.pose().some((part, axis) => Math.abs(part - still[axis]) > 5), still);
}));

test("a point is taught and saved, and nothing else is", () => served(BOXES, async (run) => {
  const file = join(run.folder, POINTS);
  const before = readFileSync(file, "latin1");
  const page = await run.open();
  await until(page, 3);
  await page.getByRole("tab", { name: "Points" }).click();
  const point = await page.evaluate(() => window.val3View.store.panels.cell.points.value.find(({ name }) => !name.includes(":")));
  const name = point.key === null ? point.name : `${point.name}[${point.key}]`;
  await page.getByRole("button", { name, exact: true }).click();
  await page.getByRole("button", { name: /here/i }).click();
  const save = page.getByRole("button", { name: "Save to .dtx (1)" });
  await save.click();
  await page.getByText("Saved palletiser.dtx.").waitFor();
  const saved = readFileSync(file, "latin1");
  const lines = before.split("\n");
  const changed = saved.split("\n").filter((line, number) => line !== lines[number]);
  assert.equal(changed.length, 1, changed.join("\n"));
  assert.match(changed[0], / x="/);
  const [now] = await page.evaluate((name) => window.val3View.store.panels.cell.points.value.filter((point) => point.name === name).map(({ local }) => local), point.name);
  assert.ok(changed[0].includes(`x="${now[0]}"`), `${changed[0]} has ${now}`);

  const edited = `${saved}<!-- by hand -->\n`;
  writeFileSync(file, edited, "latin1");
  await until(page, 4.5);
  await page.getByRole("button", { name: /here/i }).click();
  await save.click();
  await page.getByRole("button", { name: "Keep the file" }).click();
  assert.equal(readFileSync(file, "latin1"), edited);
  await save.click();
  await page.getByRole("button", { name: "Overwrite" }).click();
  await page.getByText("Saved palletiser.dtx.").waitFor();
  const overwritten = readFileSync(file, "latin1");
  assert.notEqual(overwritten, edited);
  assert.ok(overwritten.endsWith("<!-- by hand -->\n"));
}));

test("an exported run plays from the disk with the poses of its trace", () => served([...BOXES, "--export", "run.html", "--trace", "trace.csv"], async (run) => {
  const live = await run.open();
  await until(live, 6);
  await run.end();
  const page = await openFile(join(run.folder, "run.html"));
  await page.waitForFunction(() => window.val3View?.store.end.value !== undefined);
  assert.equal(await page.evaluate(() => window.val3View.store.scene.value.role), "recording");
  const row = readFileSync(join(run.folder, "trace.csv"), "utf8").trim().split("\n").at(-200).split(",").map(Number);
  const pose = await page.evaluate((time) => {
    window.val3View.store.chosen.value = time;
    return window.val3View.pose();
  }, row[0]);
  assert.ok(Math.hypot(...[0, 1, 2].map((axis) => pose[axis] - row[9 + axis])) < 0.002, `${pose} ${row}`);
  await page.evaluate(() => (window.val3View.store.chosen.value = 0));
  await page.getByRole("button", { name: /play/i }).first().click();
  await page.waitForFunction(() => window.val3View.store.time.value > 0.3);
}));
