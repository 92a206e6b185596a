// The palletiser in a browser: its arm, its time and its viewers.
const assert = require("node:assert/strict");
const { readFileSync } = require("node:fs");
const { join } = require("node:path");
const { test } = require("node:test");
const { BOXES, moveForever, now, served, setProgram, until } = require("./served.js");

const pose = (page) => page.evaluate(() => window.val3View.pose());

/** Waits until the arm differs from a pose by more than 5 mm or degrees. */
const hasMoved = (page, from) => page.waitForFunction(
  (from) => window.val3View.pose().some((part, axis) => Math.abs(part - from[axis]) > 5), from);

/** Waits until the figures of the readout name a thing. */
const readout = (page, name) => page.locator(".foot").getByText(name, { exact: true }).waitFor();

test("the arm is seen to move, and its poses are those of the trace", () => served(["--power", "--trace", "trace.csv"], async (run) => {
  const page = await run.open();
  for (const name of ["X", "RZ", "J1", "J6", "Speed", "Tool"]) {
    await readout(page, name);
  }
  const picture = page.locator("canvas").first();
  await until(page, 0.2);
  const still = await picture.screenshot();
  await hasMoved(page, await pose(page));
  assert.notDeepEqual(await picture.screenshot(), still);
  await page.evaluate(() => (window.val3View.store.chosen.value = 0));
  await until(page, 6);
  const times = [2.5, 3, 3.504, 4, 4.5, 5.2];
  const poses = await page.evaluate(async (times) => {
    const found = [];
    for (const time of times) {
      window.val3View.store.chosen.value = time;
      found.push(window.val3View.pose());
    }
    return found;
  }, times);
  await run.end();
  const rows = readFileSync(join(run.folder, "trace.csv"), "utf8").trim().split("\n").slice(1).map((row) => row.split(","));
  times.forEach((time, number) => {
    const row = rows.findLast(([t]) => Number(t) <= time + 1e-9);
    const expected = row.slice(9, 12).map(Number);
    const distance = Math.hypot(...expected.map((coordinate, axis) => coordinate - poses[number][axis]));
    assert.ok(distance < 0.002, `${time}: ${poses[number]} instead of ${expected}`);
  });
}, moveForever));

test("an emergency stop holds the arm until it is released and the power is on again", () => served(["--power"], async (run) => {
  const page = await run.open();
  await hasMoved(page, await pose(page));
  const status = page.getByRole("status", { name: "Status" });
  await page.getByRole("button", { name: "Hold", exact: true }).click();
  await status.getByText(/^The arm is held\. Press Move\. palletiser~ waits for the arm/).waitFor();
  await page.getByRole("button", { name: "Move", exact: true }).click();
  await status.getByText(/^The arm moves\./).waitFor();
  await page.getByRole("button", { name: "Pause", exact: true }).click();
  await status.getByText("The run is paused. Press Play to continue.").waitFor();
  assert.equal(await page.getByRole("button", { name: "Run", exact: true }).getAttribute("title"), "The run is paused. Press Play to continue.");
  await page.getByRole("button", { name: "Play", exact: true }).click();
  await page.getByRole("button", { name: "E-stop" }).click();
  await status.getByText(/^The E-stop is pressed\./).waitFor();
  await until(page, (await now(page)) + 1);
  const held = await pose(page);
  await until(page, (await now(page)) + 1);
  assert.deepEqual(await pose(page), held);
  await page.getByRole("button", { name: "Release E-stop" }).click();
  await page.getByRole("button", { name: "Switch power on" }).click();
  await page.getByRole("button", { name: "Switch power off" }).waitFor();
  const move = page.getByRole("button", { name: "Move", exact: true });
  if (await move.isVisible()) {
    await move.click();
  }
  await hasMoved(page, held);
}, moveForever));

test("the time is moved back while the run continues", () => served(BOXES, async (run) => {
  const page = await run.open();
  await until(page, 3);
  await page.getByRole("slider").first().focus();
  await page.keyboard.press("Home");
  await page.waitForFunction(() => window.val3View.store.time.value === 0);
  assert.ok((await now(page)) >= 3, "the run goes on");
  // A stop acts on the present, which the page then shows.
  await page.getByLabel("Playback speed").waitFor();
  await page.getByRole("button", { name: "E-stop now" }).click();
  await page.getByText("The E-stop was pressed. The page shows the present again.").waitFor();
  await page.waitForFunction(() => window.val3View.store.chosen.value === undefined && window.val3View.store.panels.cell.state.value.emergencyStop === "open");
  await page.getByLabel("Clock speed").waitFor();
}));

test("a guest looks but does not operate", () => served(BOXES, async (run) => {
  const page = await run.open(1);
  assert.equal(await page.evaluate(() => window.val3View.store.scene.value.role), "guest");
  const answer = await page.evaluate(() => window.val3View.store.command("operate", { keys: { power: false } }));
  assert.match(answer.error, /guest/);
}));

test("viewers see the same run", () => served(BOXES, async (run) => {
  const pages = [await run.open(0), await run.open(1)];
  await Promise.all(pages.map((page) => until(page, 2)));
  const poses = await Promise.all(pages.map((page) => page.evaluate(() => {
    window.val3View.store.chosen.value = 1.8;
    return window.val3View.pose();
  })));
  assert.deepEqual(poses[0], poses[1]);
}));

test("a fault is a red bar with its cause and its line, and a number on the tab", () => served([], async (run) => {
  const page = await run.open();
  const bar = page.getByRole("alert", { name: "Fault" });
  await bar.getByText(/^Error 10: division by zero in task palletiser~ at start:\d+$/).waitFor();
  await page.getByText(/^palletiser~ has failed with error 10 at start:\d+\. Press Run to start the application again\.$/).waitFor();
  await page.getByRole("tab", { name: /Tasks\s*1/ }).waitFor();
  await page.waitForFunction(() => document.title === "palletiser – fault");
  await bar.getByRole("button", { name: "Hide this fault" }).click();
  assert.equal(await bar.count(), 0);
}, (folder) => setProgram(folder, '\n  delay(0.2)\n  putln(toString("",1/0))')));

test("the target of a refused move is marked in the picture", () => served(["--power"], async (run) => {
  const page = await run.open();
  await page.getByRole("alert", { name: "Fault" }).getByText(/^Error 154: move not possible/).waitFor();
  await page.locator(".name.failed").getByText(/^movel at start:\d+ fails$/).waitFor();
}, (folder) => setProgram(folder, `
  pSafe.trsf={900,0,1500,0,0,0}
  movel(pSafe,flange,mFast)`)));

test("the target of a move whose path the arm cannot follow is marked in the picture", () => served(["--arm", "TX2-90", "--power"], async (run) => {
  const page = await run.open();
  await page.getByRole("alert", { name: "Fault" }).getByText(/^The arm cannot follow the path of movel: on the blend around the destination/).waitFor();
  await page.locator(".name.failed").getByText(/^movel at start:\d+ fails$/).waitFor();
  const [failed] = await page.evaluate(() => window.val3View.store.panels.cell.motion.value.queue);
  assert.deepEqual(failed.target.slice(0, 2).map(Math.round), [80, -80]);
}, (folder) => setProgram(folder, `
  jHome={0,0,90,0,90,0}
  mFast.blend=off
  movej(jHome,flange,mFast)
  waitEndMove()
  pSafe=here(flange,world)
  pSafe.trsf.x=80
  pSafe.trsf.y=300
  movej(pSafe,flange,mFast)
  // The blend would move the centre of the wrist too near to axis 1.
  mFast.blend=Cartesian
  mFast.leave=200
  mFast.reach=200
  pSafe.trsf.y=-80
  movel(pSafe,flange,mFast)
  pSafe.trsf.x=-300
  movel(pSafe,flange,mFast)
  wait(false)`)));

test("a run without power tells which button helps", () => served([], async (run) => {
  const page = await run.open();
  await page.getByText("The arm has no power. Switch the power on.").waitFor();
  await page.waitForFunction(() => document.title === "palletiser – arm held");
}));

test("panels fold, and their size and the shown tab survive a reload", () => served(BOXES, async (run) => {
  const page = await run.open();
  await page.getByRole("separator", { name: "Size of the panels" }).focus();
  const width = () => page.locator(".picture").evaluate((picture) => picture.clientWidth);
  const before = await width();
  await page.keyboard.press("ArrowRight");
  await page.waitForFunction((before) => document.querySelector(".picture").clientWidth > before, before);
  const chosen = await width();
  await page.getByRole("tab", { name: "Tasks" }).click();
  const layer = page.getByRole("checkbox", { name: "Points" });
  await page.getByText("Layers", { exact: true }).click();
  await layer.uncheck();
  await page.getByRole("button", { name: "Dark", exact: true }).click();
  await page.reload();
  await page.getByRole("tab", { name: "Tasks", selected: true }).first().waitFor();
  assert.equal(await width(), chosen);
  assert.equal(await page.evaluate(() => document.documentElement.dataset.theme), "dark");
  await page.getByText("Layers", { exact: true }).click();
  assert.equal(await layer.isChecked(), false);
  await page.getByRole("button", { name: "Panels" }).click();
  await page.getByRole("separator").waitFor({ state: "detached" });
  await page.waitForFunction((chosen) => document.querySelector(".picture").clientWidth > chosen, chosen);
}));
