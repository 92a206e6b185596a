// Joint positions, frames and tools are taught by positions of the arm, which is jogged along joints, tool and frames.
// The reach of points follows the chosen tool.
const assert = require("node:assert/strict");
const { readFileSync, writeFileSync } = require("node:fs");
const { join } = require("node:path");
const { test } = require("node:test");
const { hold, isAt, jogTo, served } = require("./served.js");

const POINTS = "usr/usrapp/palletiser/palletiser.dtx";

/** Switches to manual mode with power. */
async function toManual(page) {
  await page.getByLabel(/mode/i).first().selectOption("manual");
  await page.getByRole("button", { name: "Switch power on" }).click();
  await page.getByRole("button", { name: "Switch power off" }).waitFor();
}

/** Checks that the last axis is visible. */
async function isAboveTimeBar(page) {
  const box = await page.getByRole("button", { name: "J6 plus" }).boundingBox();
  const bar = await page.locator(".time-bar").boundingBox();
  const { width, height } = page.viewportSize();
  assert.ok(Math.floor(box.y + box.height) <= bar.y, `J6 ends at ${box.y + box.height} of ${bar.y} in ${width}x${height}`);
}

/** Jogs to the joints, and presses the button of each position. */
async function teach(page, value, positions) {
  await page.getByRole("combobox", { name: /^Frame or tool/ }).selectOption(value);
  for (const [name, joints] of positions) {
    await jogTo(page, joints);
    await page.getByRole("button", { name, exact: true }).click();
  }
  await page.getByRole("button", { name: `Compute ${value}` }).click();
}

test("a frame and a tool are taught, undone and saved", () => served([], async (run) => {
  const page = await run.open();
  await toManual(page);
  await page.getByRole("tab", { name: "Points" }).click();
  const values = (kind) => page.evaluate((kind) => window.val3View.store.panels.cell[kind].value, kind);
  const [[frame], [tool]] = [await values("frames"), await values("tools")];

  await page.getByRole("combobox", { name: /^Tool/ }).selectOption("flange");
  await teach(page, frame.name, [["Origin", [0, 20, 90, 0, 60, 0]], ["On the x axis", [0, 30, 90, 0, 50, 0]], ["In the xy plane", [20, 20, 90, 0, 60, 0]]]);
  await page.getByText("Computed.").waitFor();
  await page.waitForFunction((before) => window.val3View.store.panels.cell.frames.value[0].pose.join() !== before, frame.pose.join());
  await page.getByRole("button", { name: `Undo ${frame.name}` }).click();
  await page.waitForFunction((before) => window.val3View.store.panels.cell.frames.value[0].pose.join() === before, frame.pose.join());

  const tilted = [[0, 20, 90, 0, 60, 0], [0, 20, 90, 40, 60, 0], [0, 20, 90, 0, 90, 20], [0, 20, 90, -40, 60, 0]];
  await teach(page, tool.name, tilted.map((joints, index) => [`Position ${index + 1}`, joints]));
  await page.getByText(/^Computed; the tip is at most [\d.]+ mm from the touched place\.$/).waitFor();
  await page.getByRole("button", { name: "Position 2 ✓" }).click();
  await page.getByRole("button", { name: `Compute ${tool.name}` }).click();
  await page.getByText("the orientations of positions 2 and 4 are less than 5 degrees apart").waitFor();

  await page.getByRole("button", { name: "Save to .dtx (1)" }).click();
  await page.getByText("Saved palletiser.dtx.").waitFor();
  // The wrist centre is the same in all positions. In the frame of the flange it is at z = -100 mm.
  const [saved] = await values("tools");
  assert.ok(Math.hypot(saved.local[0], saved.local[1], saved.local[2] + 100) < 1e-6, saved.local.join());
  assert.match(readFileSync(join(run.folder, POINTS), "latin1"), /name="tGripper"[^>]*>\s*<Value key="0" (?:[xy]="-?0(?:\.0+)?" )*z="-100"/);
}));

test("a joint position is taught, and the arm goes to it by hand", () => served([], async (run) => {
  const page = await run.open();
  await toManual(page);
  const taught = [12.5, 10, 95, -20, 40, 30];
  await jogTo(page, taught);
  await page.getByRole("tab", { name: "Points" }).click();
  await page.getByRole("button", { name: "jHome", exact: true }).click();
  await page.getByRole("button", { name: "Teach here: joints of the arm" }).click();
  const save = page.getByRole("button", { name: "Save to .dtx (1)" });
  await save.waitFor();
  const values = () => page.evaluate(() => window.val3View.store.panels.cell.joints.value.find(({ name }) => name === "jHome").values);
  await page.waitForFunction(() => window.val3View.store.panels.cell.joints.value.find(({ name }) => name === "jHome").values[0] === 12.5);
  assert.deepEqual((await values()).map((value) => Number(value.toFixed(6))), taught);

  await jogTo(page, [-10, 10, 95, -20, 40, 30]);
  await page.waitForFunction(() => window.val3View.store.panels.cell.armGoal.value?.text === "jHome");
  const arrives = (joints) => joints.every((joint, axis) => Math.abs(joint - window.val3View.store.panels.cell.sample.value.joints[axis]) < 1e-3);
  await hold(page, page.getByRole("button", { name: "Go to jHome" }), arrives, taught);
  await save.click();
  await page.getByText("Saved palletiser.dtx.").waitFor();
  assert.match(readFileSync(join(run.folder, POINTS), "latin1"), /name="jHome"[^>]*>\s*<Value key="0" j1="12.5" j2="10" j3="95" j4="-20" j5="40" j6="30" \/>/);

  await page.getByRole("button", { name: "Undo jHome" }).click();
  await page.getByText("Saved palletiser.dtx.").waitFor({ state: "detached" });
  await page.waitForFunction(() => window.val3View.store.panels.cell.joints.value.find(({ name }) => name === "jHome").values[2] === 110);
  await hold(page, page.getByRole("button", { name: "Go to jHome" }), arrives, [0, -20, 110, 0, 90, 0]);
}));

/** Unit vectors along the axes of a pose in degrees, rotated about x, then the new y, then the new z. */
function axesOf([, , , rx, ry, rz]) {
  const [a, b, c] = [rx, ry, rz].map((angle) => (angle * Math.PI) / 180);
  const [sa, ca, sb, cb, sc, cc] = [Math.sin(a), Math.cos(a), Math.sin(b), Math.cos(b), Math.sin(c), Math.cos(c)];
  return {
    X: [cb * cc, ca * sc + sa * sb * cc, sa * sc - ca * sb * cc],
    Y: [-cb * sc, ca * cc - sa * sb * sc, sa * cc + ca * sb * sc],
    Z: [sb, -sa * cb, ca * cb],
  };
}

test("the arm is jogged along and about the axes of the tool and of a frame", () => served([], async (run) => {
  const page = await run.open();
  await toManual(page);
  await jogTo(page, [20, 10, 90, 15, 60, 25]);
  await page.getByRole("combobox", { name: /^Step/ }).selectOption({ label: "10 mm, 10°" });
  const pose = () => page.evaluate(() => window.val3View.pose());
  /** Presses a button, and returns the pose before, and after the arm has come to rest. */
  const step = async (name) => {
    const before = await pose();
    await page.getByRole("button", { name, exact: true }).focus();
    await page.keyboard.press("Enter");
    // A resting arm sends no samples.
    await page.waitForFunction((before) => {
      const { newest, samples } = window.val3View.store;
      return newest.value > samples.end() + 0.2 && Math.hypot(...window.val3View.pose().map((value, axis) => value - before[axis])) > 3;
    }, before);
    return [before, await pose()];
  };
  const frame = await page.evaluate(() => window.val3View.store.panels.cell.frames.value.find(({ name }) => name === "fPallet").pose);
  for (const [way, axes] of [["tool", undefined], ["frame:fPallet", axesOf(frame)]]) {
    await page.getByRole("combobox", { name: /^Along/ }).selectOption(way);
    for (const name of ["X", "Y", "Z"]) {
      const [before, after] = await step(`${name} plus`);
      const expected = (axes ?? axesOf(before))[name];
      expected.forEach((part, axis) => assert.ok(Math.abs(after[axis] - before[axis] - 10 * part) < 0.05, `${way} ${name}: ${before} to ${after}, not along ${expected}`));
      after.slice(3).forEach((angle, axis) => assert.ok(Math.abs(angle - before[axis + 3]) < 0.02, `${way} ${name} turns: ${before} to ${after}`));
    }
    const [before, after] = await step("RZ plus");
    before.slice(0, 3).forEach((part, axis) => assert.ok(Math.abs(after[axis] - part) < 0.05, `${way} RZ moves: ${before} to ${after}`));
    const [from, to] = [axesOf(before), axesOf(after)];
    const about = (axes ?? from).Z;
    for (const name of ["X", "Y", "Z"]) {
      const along = (vector) => vector.reduce((sum, part, axis) => sum + part * about[axis], 0);
      assert.ok(Math.abs(along(from[name]) - along(to[name])) < 1e-3, `${way} RZ: ${name} turns about another axis`);
    }
  }
}));

test("points out of reach have their own colour in the picture", () => served([], async (run) => {
  const page = await run.open();
  await page.locator(".legend").getByText("out of reach").waitFor();
  await page.getByRole("tab", { name: "Points" }).click();
  const names = await page.evaluate(() => [...window.val3View.store.panels.cell.unreachable.value.reasons.keys()]);
  assert.ok(names.includes("pFar"), names.join());
  await page.getByRole("button", { name: "pFar", exact: true }).click();
  await page.locator(".names").getByText("pFar (out of reach)").waitFor();
  await page.getByRole("row", { name: /^pFar out of reach/ }).waitFor();
  await page.getByRole("combobox", { name: /^Tool/ }).selectOption("tSuction");
  await page.locator(".legend").getByText("out of reach of tSuction").waitFor();
  await page.getByRole("button", { name: "Reach", exact: true }).click();
  await page.locator(".legend").getByText("reach of tSuction", { exact: true }).waitFor();

  const guest = await run.open(1);
  await guest.locator(".legend").getByText(/^out of reach of (flange|tSuction)$/).waitFor();
  await guest.waitForFunction(() => window.val3View.store.panels.cell.unreachable.value.reasons.get("pFar")?.includes("mm from"));
}, (folder) => {
  const file = join(folder, POINTS);
  const far = '<Data name="pFar" access="private" xsi:type="array" type="pointRx" size="1"><Value key="0" x="1500" fatherId="fCell[0]" /></Data>';
  writeFileSync(file, readFileSync(file, "latin1").replace('<Data name="pPick"', (pick) => `${far}\n    ${pick}`), "latin1");
}));

test("entered joints have the limits of the axes, and the arm goes there", () => served([], async (run) => {
  const page = await run.open();
  await toManual(page);
  await page.getByRole("button", { name: "Enter joints…" }).click();
  const fields = page.getByRole("group", { name: "Joints to go to" });
  await fields.getByLabel("J1").fill("999");
  await fields.getByText(/^J1 is 999, outside the range from -\d+ to \d+ degrees\.$/).waitFor();
  await fields.getByLabel("J1").fill("6,5");
  await hold(page, fields.getByRole("button", { name: "Go to the entered joints" }), () => Math.abs(window.val3View.store.panels.cell.sample.value.joints[0] - 6.5) < 1e-3);
}));

test("in manual mode, jogging needs no scrolling in a small window", () => served([], async (run) => {
  const page = await run.open();
  await toManual(page);
  for (const [width, height] of [[1280, 800], [1366, 768], [900, 500]]) {
    await page.setViewportSize({ width, height });
    await isAboveTimeBar(page);
  }
}));

test("the axes are visible below a user page", () => served([], async (run) => {
  const page = await run.open();
  await page.getByText("State    stopped").waitFor();
  for (const [width, height] of [[1280, 800], [1366, 768], [1920, 1080]]) {
    await page.setViewportSize({ width, height });
    await isAboveTimeBar(page);
  }
}));
