// The picture of the cell: its first view, views along the axes, layers, names, legend, and the path of an export.
const assert = require("node:assert/strict");
const { createHash } = require("node:crypto");
const { readFileSync, rmSync, writeFileSync } = require("node:fs");
const { join } = require("node:path");
const { test } = require("node:test");
const { openFile, served, setProgram } = require("./served.js");

const FOLDER = "usr/usrapp/palletiser";

/** Moves after an input, and then waits without end. */
const MOVES = `
  wait(io:diPart)
  movej(jHome,tGripper,mFast)
  jHome.j1=60
  movej(jHome,tGripper,mFast)
  jHome.j1=-60
  movej(jHome,tGripper,mFast)
  waitEndMove()
  wait(false)`;

/** Sets the input of the program. */
const begin = (page) => page.evaluate(() => window.val3View.store.command("operate", { keys: { io: { "BasicIO-1\\%I0": true } } }));

/** Waits until the arm moves no more, after some moves. */
const rests = (page) => page.waitForFunction(() => {
  const { newest, samples } = window.val3View.store;
  return samples.count > 100 && newest.value > samples.end() + 0.3;
});

/** Returns the names of the parts over the picture that cover the arm, and of the sides at which the arm leaves the picture. */
function hidden() {
  const canvas = document.querySelector(".picture canvas");
  if (canvas === null) {
    return ["no picture"]; // The layout of another width is being built.
  }
  const { left, top, width, height } = canvas.getBoundingClientRect();
  const bars = [...document.querySelectorAll(".picture-tools > *, .picture .legend, .picture .position")].map((bar) => [bar.className, bar.getBoundingClientRect()]);
  const faults = new Set();
  for (const [x, y] of window.val3View.outline().map(window.val3View.locationOf)) {
    const sides = { left: x < 0, right: x > width, top: y < 0, bottom: y > height };
    Object.entries(sides).filter(([, isOutside]) => isOutside).forEach(([side]) => faults.add(side));
    const isCovered = ([, bar]) => x > bar.left - left + 1 && x < bar.right - left - 1 && y > bar.top - top + 1 && y < bar.bottom - top - 1;
    bars.filter(isCovered).forEach(([name]) => faults.add(name));
  }
  return [...faults];
}

/** Waits until the picture holds the complete arm, and nothing covers it. */
async function showsArm(page, when) {
  await page.waitForFunction(() => window.val3View.outline().length > 0);
  // The picture follows a change of the window some frames later.
  const fault = await page.waitForFunction(`(${hidden})().length === 0`).then(() => undefined, (error) => error);
  assert.equal(fault, undefined, `${when}: ${fault?.message} ${await page.evaluate(hidden)}`);
}

/** Returns a value as soon as two frames in a row have it. */
async function settled(page, read) {
  const frame = () => page.evaluate(() => new Promise((resolve) => { requestAnimationFrame(() => requestAnimationFrame(resolve)); }));
  let before;
  for (let now = await read(); JSON.stringify(now) !== before; now = await read()) {
    before = JSON.stringify(now);
    await frame();
  }
  return JSON.parse(before);
}

/** Returns a digest of the drawing without the parts of the page over it. */
async function drawing(page) {
  await page.evaluate(() => document.querySelectorAll(".picture > :not(canvas)").forEach((part) => { part.style.visibility = "hidden"; }));
  return settled(page, async () => createHash("sha256").update(await page.locator(".picture canvas").screenshot()).digest("hex"));
}

/** Waits until the drawing has a property. A loaded machine draws a change some frames later. */
async function becomes(page, isAsExpected, message) {
  for (const end = Date.now() + 30_000; Date.now() < end;) {
    if (isAsExpected(await drawing(page))) {
      return;
    }
  }
  assert.fail(message);
}

/** Shows or hides a layer, also while the menu is hidden. */
const choose = (page, layer) => page.locator(".layers label").filter({ hasText: new RegExp(`^ ?${layer}$`) }).locator("input").evaluate((box) => box.click());

/** Replaces the palletiser by an application without points and frames, which moves by joints only. */
function withoutPoints(folder) {
  const write = (name, text) => writeFileSync(join(folder, FOLDER, name), `<?xml version="1.0" encoding="utf-8"?>\n${text}\n`, "latin1");
  const namespace = "http://www.staubli.com/robotics/VAL3";
  rmSync(join(folder, "val3.toml"));
  write("palletiser.pjx", `<Project xmlns="${namespace}/Project/3"><Parameters version="s7.11.3" stackSize="5000" millimeterUnit="true" />
    <Programs><Program file="start.pgx" /><Program file="stop.pgx" /></Programs><Database><Data file="palletiser.dtx" /></Database><Libraries /><Types /></Project>`);
  write("palletiser.dtx", `<Database xmlns:xsi="http://www.w3.org/2001/XMLSchema-instance" xmlns="${namespace}/Data/2"><Datas>
    <Data name="jA" access="private" xsi:type="array" type="jointRx" size="1"><Value key="0" j2="30" j3="60" /></Data>
    <Data name="mA" access="private" xsi:type="array" type="mdesc" size="1" /></Datas></Database>`);
  write("stop.pgx", `<Programs xmlns="${namespace}/Program/2"><Program name="stop"><Code><![CDATA[begin\nend]]></Code></Program></Programs>`);
  setProgram(folder, "\n  movej(jA,flange,mA)\n  jA.j1=120\n  movej(jA,flange,mA)\n  waitEndMove()\n  wait(false)");
}

test("the first picture holds the complete arm, also without points, and also in an export", () => served(["--arm", "tx2-60l", "--cell", "none", "--power", "--export", "run.html"], async (run) => {
  const page = await run.open();
  await showsArm(page, "at first");
  await rests(page);
  await showsArm(page, "after the moves");
  for (const [width, height] of [[1920, 1080], [900, 500], [390, 844], [1280, 800]]) {
    await page.setViewportSize({ width, height });
    await showsArm(page, `in ${width}x${height}`);
  }
  await run.end();
  const exported = await openFile(join(run.folder, "run.html"));
  await exported.waitForFunction(() => window.val3View?.store.end.value !== undefined);
  await exported.getByRole("button", { name: "Pause", exact: true }).click();
  for (const share of [0, 0.5, 1]) {
    await exported.evaluate((share) => { window.val3View.store.chosen.value = share * window.val3View.store.newest.value; }, share);
    await showsArm(exported, `${share} of the export`);
  }
  // The path of the complete run is drawn, also at its beginning.
  await exported.evaluate(() => { window.val3View.store.chosen.value = 0; });
  const complete = await drawing(exported);
  await choose(exported, "Path");
  await becomes(exported, (now) => now !== complete, "the path");
  await exported.close();
}, withoutPoints));

test("views along the axes are parallel projections, and a reload keeps the view", () => served([], async (run) => {
  const page = await run.open();
  /** Returns the locations of positions at both ends of a line of 1 m from the origin. */
  const ends = (direction) => page.evaluate((direction) => [[0, 0, 0], direction, [0, 300, 500]].map((position) => window.val3View.locationOf(position)), direction);
  const isClose = (left, right) => Math.hypot(left[0] - right[0], left[1] - right[1]) < 0.6;
  for (const [view, along] of [["Front", [1000, 0, 0]], ["Right", [0, 1000, 0]], ["Top", [0, 0, 1000]], ["Iso", undefined]]) {
    await page.getByRole("button", { name: view, exact: true }).click();
    const [near, far, other] = await settled(page, () => ends(along ?? [1000, 0, 0]));
    assert.equal(isClose(near, far), along !== undefined, `${view}: ${near} and ${far}`);
    // A line parallel to the view is a point anywhere in the picture.
    if (along !== undefined) {
      const [shifted] = await page.evaluate((at) => [window.val3View.locationOf(at)], [along[0], along[1] + 300, along[2] + 500]);
      assert.ok(isClose(other, shifted), `${view}: ${other} and ${shifted}`);
    }
  }
  await page.getByRole("button", { name: "Front", exact: true }).click();
  await page.locator(".picture canvas").focus();
  for (const key of ["ArrowLeft", "ArrowUp", "+"]) {
    await page.keyboard.press(key);
  }
  const view = () => settled(page, () => page.evaluate(() => [[0, 0, 0], [500, 0, 0], [0, 500, 0], [0, 0, 500]].flatMap((at) => window.val3View.locationOf(at)).map(Math.round)));
  const chosen = await view();
  await page.reload();
  await page.waitForFunction(() => window.val3View?.outline().length > 0);
  assert.deepEqual(await view(), chosen);
}));

test("layers hide their parts of the picture, and the legend lists only the colours in it", () => served(["--power"], async (run) => {
  const page = await run.open();
  // Some corners of the pallet are out of reach.
  const legend = async () => (await page.locator(".legend li").allInnerTexts()).filter((text) => !text.startsWith("out of reach of "));
  assert.deepEqual(await legend(), []);
  await begin(page);
  await rests(page);
  await page.waitForFunction(() => {
    const { samples, scene } = window.val3View.store;
    const phases = new Set([...samples.after(-1)].map(({ phase }) => scene.value.phases[phase]));
    phases.delete("waiting");
    const shown = [...document.querySelectorAll(".legend li")].map(({ textContent }) => textContent).filter((text) => !text.startsWith("out of reach of "));
    return phases.size > 0 && [...phases].toSorted().join() === shown.toSorted().join();
  });
  await page.getByRole("button", { name: "Fit", exact: true }).click();
  await showsArm(page, "after Fit");

  // In the middle of a move, the path ahead is drawn too.
  const middle = await page.evaluate(() => {
    const { events } = window.val3View.store.panels.cell.history;
    const starts = events.filter(({ kind, phase }) => kind === "move" && phase === "started").map(({ t }) => t);
    return (starts[1] + starts[2]) / 2;
  });
  await page.evaluate((t) => { window.val3View.store.chosen.value = t; }, middle);
  await page.locator(".legend").getByText("ahead", { exact: true }).waitFor();
  const layers = await page.locator(".layers label").allTextContents();
  assert.equal(layers.length, 7);
  const complete = await drawing(page);
  for (const layer of layers.map((layer) => layer.trim())) {
    await choose(page, layer);
    if (layer === "Names") {
      await page.waitForFunction(() => document.querySelector(".names .name:not([hidden])") === null);
    } else {
      await becomes(page, (now) => now !== complete, layer);
    }
    await choose(page, layer);
    await becomes(page, (now) => now === complete, `${layer} again`);
  }
  await choose(page, "Points");
  await page.waitForFunction(() => document.querySelector(".names .name.point:not([hidden])") === null);
  await choose(page, "Path");
  await choose(page, "Path ahead and blends");
  await page.waitForFunction(() => document.querySelector(".legend") === null);
}, (folder) => setProgram(folder, MOVES)));

/** Adds 60 points close to each other. */
function addPoints(folder) {
  const values = Array.from({ length: 60 }, (_, key) => `<Value key="${key}" x="${(key % 10) * 25}" y="${Math.floor(key / 10) * 25}" z="100" fatherId="fCell[0]" />`);
  const file = join(folder, FOLDER, "palletiser.dtx");
  const points = `<Data name="pGrid" access="private" xsi:type="array" type="pointRx" size="60">${values.join("")}</Data>`;
  writeFileSync(file, readFileSync(file, "latin1").replace('<Data name="pPick"', `${points}\n    <Data name="pPick"`), "latin1");
  setProgram(folder, "\n  wait(false)");
}

test("names of points make room for each other, for the selected point and for the parts over the picture", () => served([], async (run) => {
  const page = await run.open();
  const boxes = () => page.evaluate(() => [...document.querySelectorAll(".names .name:not([hidden]), .picture-tools > *, .picture .legend, .picture .position")].map((part) => {
    const { left, top, right, bottom } = part.getBoundingClientRect();
    return { name: part.textContent, left, top, right, bottom };
  }));
  for (const [width, height] of [[1280, 800], [900, 500], [390, 844]]) {
    await page.setViewportSize({ width, height });
    const shown = await settled(page, boxes);
    const overlaps = shown.flatMap((a, index) => shown.slice(index + 1).filter((b) => a.left < b.right - 1 && b.left < a.right - 1 && a.top < b.bottom - 1 && b.top < a.bottom - 1).map((b) => `${a.name} and ${b.name}`));
    assert.deepEqual(overlaps, [], `${width}x${height}`);
  }
  await page.setViewportSize({ width: 1280, height: 800 });
  const names = (await settled(page, boxes)).filter(({ name }) => name.startsWith("pGrid"));
  assert.ok(names.length > 0 && names.length < 60, `${names.length} names`);
  const covered = await page.evaluate((shown) => window.val3View.store.panels.cell.points.value.find(({ name, key }) => name === "pGrid" && !shown.includes(`pGrid[${key}]`)).key, names.map(({ name }) => name));
  await page.evaluate((key) => { window.val3View.store.selection.value = { kind: "point", point: { name: "pGrid", key } }; }, covered);
  await page.locator(".names .name.selected").getByText(`pGrid[${covered}]`).waitFor();
}, addPoints));
