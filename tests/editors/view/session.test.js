// A session that only uses the page: a fault, its repair, points that are taught with two tools, and a second start.
const assert = require("node:assert/strict");
const { mkdirSync, readFileSync } = require("node:fs");
const { join } = require("node:path");
const { test } = require("node:test");
const { hold, isAt, jogTo, served, setProgram } = require("./served.js");

const POINTS = "usr/usrapp/palletiser/palletiser.dtx";
const SIZES = [[1280, 800], [1366, 768], [1920, 1080], [390, 844]];

/** Points with the tool with which they are taught, and the joints of the arm meanwhile. */
const TAUGHT = [
  ["pCorner[1]", "tGripper", [10, 20, 90, 0, 60, 0]],
  ["pCorner[2]", "tSuction", [-10, 30, 80, 0, 50, 20]],
  ["pPick", "tSuction", [25, 10, 95, 10, 55, 0]],
];

/** Stores pictures of the page in all sizes and both looks, where `VAL3_OUTPUT` names a folder. */
async function pictures(page, name) {
  if (process.env.VAL3_OUTPUT === undefined) {
    return;
  }
  const folder = join(process.env.VAL3_OUTPUT, "view");
  mkdirSync(folder, { recursive: true });
  for (const [width, height] of SIZES) {
    await page.setViewportSize({ width, height });
    for (const look of ["light", "dark"]) {
      await page.emulateMedia({ colorScheme: look });
      await page.waitForTimeout(300);
      await page.screenshot({ path: join(folder, `session-${name}-${width}-${look}.png`) });
    }
  }
  await page.emulateMedia({ colorScheme: "light" });
  await page.setViewportSize({ width: SIZES[0][0], height: SIZES[0][1] });
}

async function powerOn(page) {
  await page.getByRole("button", { name: "Switch power on" }).click();
  await page.getByRole("button", { name: "Switch power off" }).waitFor();
}

async function stop(page) {
  await page.getByRole("tab", { name: "Pendant" }).click();
  await page.getByRole("button", { name: "Stop", exact: true }).click();
  await page.waitForFunction(() => window.val3View.store.end.value !== undefined);
}

async function start(page) {
  await page.getByRole("tab", { name: "Pendant" }).click();
  await page.getByRole("button", { name: "Run", exact: true }).click();
  await page.waitForFunction(() => window.val3View.store.end.value === undefined);
}

const locals = (page) => page.evaluate(() => Object.fromEntries(
  window.val3View.store.panels.cell.points.value.map(({ name, key, local }) => [key === null ? name : `${name}[${key}]`, local.map((value) => Number(value.toFixed(6)))])));

test("a fault is repaired, points are taught with two tools and saved, and the application starts again with them", () => served([], async (run) => {
  const page = await run.open();
  const fault = page.getByRole("alert", { name: "Fault" });
  await powerOn(page);
  await fault.getByText(/^Error 10: division by zero/).waitFor();
  await pictures(page, "fault");

  setProgram(run.folder, '\n  movej(jHome,tGripper,mFast)\n  waitEndMove()\n  putln("at home")\n  wait(false)');
  await stop(page);
  await start(page);
  await powerOn(page);
  await isAt(page, [0, -20, 110, 0, 90, 0], 1e-3);
  await page.getByText("at home").first().waitFor();
  assert.equal(await fault.count(), 0);

  await page.getByLabel(/mode/i).first().selectOption("manual");
  await powerOn(page);
  await page.getByRole("tab", { name: "Points" }).click();
  for (const [name, tool, joints] of TAUGHT) {
    await jogTo(page, joints);
    await page.getByRole("button", { name, exact: true }).click();
    await page.getByRole("combobox", { name: /^Tool/ }).selectOption(tool);
    await page.getByRole("button", { name: `Teach here: tool ${tool}` }).click();
    await page.getByRole("button", { name: `Undo ${name}` }).waitFor();
  }
  // Without an application, the arm is moved by hand, and points are saved.
  await stop(page);
  await jogTo(page, [0, 0, 90, 0, 45, 0]);
  await page.getByRole("tab", { name: "Points" }).click();
  const goal = () => page.evaluate(() => window.val3View.store.panels.cell.armGoal.value);
  await page.waitForFunction(() => window.val3View.store.panels.cell.armGoal.value !== undefined);
  assert.match((await goal()).text, /^pPick: /);
  await hold(page, page.getByRole("button", { name: "Go to pPick" }), (joints) => joints.every((joint, axis) => Math.abs(joint - window.val3View.store.panels.cell.sample.value.joints[axis]) < 1e-3), TAUGHT[2][2]);
  await pictures(page, "taught");
  const taught = await locals(page);
  await page.getByRole("button", { name: "Save to .dtx (3)" }).click();
  await page.getByText("Saved palletiser.dtx.").waitFor();
  const saved = readFileSync(join(run.folder, POINTS), "latin1");
  await page.getByRole("tab", { name: "Tasks" }).click();
  await page.waitForFunction(() => window.val3View.store.panels.cell.armGoal.value === undefined);

  await start(page);
  await page.waitForFunction(() => window.val3View.store.panels.cell.unsaved.value.size === 0);
  assert.deepEqual(await locals(page), taught);
  await isAt(page, TAUGHT[2][2], 1e-3);
  await powerOn(page);
  await page.getByText("at home").first().waitFor();
  assert.equal(readFileSync(join(run.folder, POINTS), "latin1"), saved);

  await stop(page);
  await page.getByRole("button", { name: "Run from initial position" }).click();
  await page.waitForFunction(() => window.val3View.store.end.value === undefined);
  await isAt(page, [0, 0, 0, 0, 0, 0], 1e-6);
}, (folder) => setProgram(folder, '\n  putln(toString("",1/0))')));
