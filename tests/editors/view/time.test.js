// The time bar, the chart of tasks and the cycle times: zoom, jumps, keys, playing, waits, and cycles of a move.
const assert = require("node:assert/strict");
const { test } = require("node:test");
const { moveForever, served, setProgram, until } = require("./served.js");

/** Three moves, the last of which rests at its leave point, and then an error. */
const PROGRAM = `
  movej(jHome,tGripper,mFast)
  waitEndMove()
  jHome.j1=60
  movej(jHome,tGripper,mFast)
  waitEndMove()
  jHome.j1=-60
  movej(jHome,tGripper,mFast)
  delay(3)
  putln(toString("",1/0))`;

const chosen = (page) => page.evaluate(() => window.val3View.store.chosen.value);
const shows = (page, time) => page.waitForFunction((time) => Math.abs((window.val3View.store.chosen.value ?? Infinity) - time) < 1e-6, time);
const slider = (page) => page.getByRole("slider", { name: "Shown time" });

/** Waits until the program has failed, and stops the clock. Returns the times of the error and of the starts of moves. */
async function fails(page) {
  await page.getByRole("alert", { name: "Fault" }).waitFor();
  await page.getByRole("button", { name: "Pause", exact: true }).click();
  await page.getByRole("button", { name: "Play", exact: true }).waitFor();
  return page.evaluate(() => {
    const { events } = window.val3View.store.panels.cell.history;
    return { error: events.find(({ kind }) => kind === "error").t, moves: events.filter(({ kind, phase }) => kind === "move" && phase === "started").map(({ t }) => t) };
  });
}

test("the time bar zooms, jumps to moves and errors, and follows the keys", () => served(["--power"], async (run) => {
  const page = await run.open();
  const { error, moves } = await fails(page);
  assert.equal(moves.length, 3);
  await page.getByRole("button", { name: "Previous error" }).click();
  await shows(page, error);
  for (const move of moves.toReversed()) {
    await page.getByRole("button", { name: "Previous move" }).click();
    await shows(page, move);
  }
  await page.getByRole("button", { name: "Next move" }).click();
  await shows(page, moves[1]);

  // The wheel zooms around the mouse. The shown range follows a jump out of it.
  await page.locator(".track").hover({ position: { x: 20, y: 8 } });
  const range = () => slider(page).evaluate(({ min, max }) => [Number(min), Number(max)]);
  const [start, end] = await range();
  for (let [least, most] = [start, end]; most - least > 2;) {
    const before = most - least;
    await page.mouse.wheel(0, -200);
    await page.waitForFunction((before) => document.querySelector(".track input").max - document.querySelector(".track input").min < before, before);
    [least, most] = await range();
  }
  await page.getByRole("button", { name: "Next error" }).click();
  await shows(page, error);
  await page.waitForFunction((error) => Number(document.querySelector(".track input").max) >= error, Number(error));
  const [from, to] = await range();
  assert.ok(from > start && from <= error && to >= error && to - from < 2, `${from} to ${to}`);
  await page.locator(".whole").click();
  await page.waitForFunction(([start, end]) => {
    const { min, max } = document.querySelector(".track input");
    return Number(min) === start && Number(max) === end;
  }, [start, end]);

  // Keys act where no part of the page has the focus.
  await page.getByRole("heading", { level: 1 }).click();
  for (const [key, step] of [["ArrowLeft", -0.004], ["Shift+ArrowLeft", -0.1], ["ArrowRight", 0.004]]) {
    const before = await chosen(page);
    await page.keyboard.press(key);
    await shows(page, before + step);
  }
  await page.keyboard.press("Home");
  await shows(page, 0);
  await page.keyboard.press("Space");
  await page.waitForFunction(() => window.val3View.store.time.value > 0.2);
  await page.keyboard.press("Space");
  const stopped = await chosen(page);
  await page.getByRole("button", { name: "Play", exact: true }).waitFor();
  assert.equal(await chosen(page), stopped);
  await page.keyboard.press("End");
  await page.waitForFunction(() => window.val3View.store.chosen.value === undefined);
}, (folder) => setProgram(folder, PROGRAM)));

test("the chart of tasks shows the waits of the arm and of tasks", () => served(["--power"], async (run) => {
  const page = await run.open();
  const { error, moves } = await fails(page);
  await page.getByRole("tab", { name: /^Tasks\s*1/ }).click();
  await page.getByRole("button", { name: "All", exact: true }).click();
  const chart = page.getByRole("img", { name: /^Chart of 1 tasks and 3 moves/ });
  const hint = page.locator(".chart .hint");
  const whole = await page.evaluate(() => window.val3View.store.panels.cell.range.value);
  /** Moves the mouse to a time in a lane of the chart. Returns the colour there. */
  const point = async (t, lane) => {
    const { width } = await chart.boundingBox();
    const place = { x: 96 + ((t - whole[0]) / (whole[1] - whole[0])) * (width - 96), y: lane * 22 + 11 };
    await chart.hover({ position: place });
    return chart.evaluate((canvas, { x, y }) => {
      const scale = canvas.width / canvas.clientWidth;
      return [...canvas.getContext("2d").getImageData(Math.round(x * scale), Math.round(y * scale), 1, 1).data].join();
    }, place);
  };
  const moving = await point((moves[1] + moves[2]) / 2, 0);
  await hint.getByText(/^movej \d+ at start:\d+$/).waitFor();
  const resting = await point(error - 0.5, 0);
  await hint.getByText(/^movej \d+ at start:\d+, waits for the next move$/).waitFor();
  assert.notEqual(moving, resting);
  await point(error - 0.5, 1);
  await hint.getByText(/^palletiser~ waits for /).waitFor();
  const waits = page.getByRole("table").filter({ has: page.locator("caption", { hasText: /^Waits from/ }) });
  await waits.getByRole("row").filter({ hasText: "the arm" }).first().waitFor();
}, (folder) => setProgram(folder, PROGRAM)));

test("the cycles of a move have their times, and begin at a time that can be shown", () => served(["--power"], async (run) => {
  const page = await run.open();
  await until(page, 5);
  await page.getByRole("tab", { name: "Tasks" }).click();
  await page.getByRole("tab", { name: "Times" }).click();
  const events = page.getByRole("combobox", { name: "Cycles from each" });
  await events.locator("option", { hasText: /^Move in start:7 \((?:[3-9]|\d\d+) times\)$/ }).waitFor({ state: "attached" });
  await events.selectOption("Move in start:7");
  await page.getByText(/^\d+ cycles: first \d+\.\d{3} s, min \d+\.\d{3} s, mean \d+\.\d{3} s, max \d+\.\d{3} s$/).waitFor();
  const begin = await page.evaluate(() => window.val3View.store.panels.cell.history.moves.all().find(({ line, started }) => line === 7 && started !== undefined).started);
  await page.getByRole("button", { name: `${begin.toFixed(3)} s`, exact: true }).click();
  await shows(page, begin);
}, moveForever));
