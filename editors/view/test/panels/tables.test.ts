import assert from "node:assert/strict";
import { test } from "node:test";
import { PanelHistory } from "../../src/panels/shared/history";
import { nextTab } from "../../src/panels/shared/Tabs";
import { visibleRows } from "../../src/panels/shared/visibleRows";
import { shifted, ticks, zoomed } from "../../src/panels/tasks/range";
import { countUpTo } from "../../src/panels/tasks/upTo";

test("only the rows on the screen are drawn", () => {
  assert.deepEqual(visibleRows(1000, 28, 0, 280), { first: 0, end: 26 });
  assert.deepEqual(visibleRows(1000, 28, 2800, 280), { first: 92, end: 118 });
  assert.deepEqual(visibleRows(5, 28, 2800, 280), { first: 0, end: 5 });
  assert.deepEqual(visibleRows(0, 28, 0, 280), { first: 0, end: 0 });
});

test("entries up to a time are counted", () => {
  const entries = [0, 1, 1, 2].map((t) => ({ t }));
  assert.deepEqual([-1, 0, 1, 5].map((t) => countUpTo(entries, t)), [0, 1, 3, 4]);
});

test("the arrow keys move between tabs", () => {
  assert.deepEqual(["ArrowRight", "ArrowLeft", "Home", "End", "a"].map((key) => nextTab(0, 4, key)), [1, 3, 0, 3, undefined]);
});

test("the chart is zoomed around a time and stays within the run", () => {
  assert.deepEqual(zoomed([0, 10], 0.5, 5, [0, 10]), [2.5, 7.5]);
  assert.deepEqual(zoomed([0, 10], 0.5, 0, [0, 10]), [0, 5]);
  assert.deepEqual(zoomed([2, 4], 100, 3, [0, 10]), [0, 10]);
  assert.deepEqual(shifted([2, 4], 10, [0, 10]), [8, 10]);
  assert.deepEqual(shifted([2, 4], -10, [0, 10]), [0, 2]);
  const [start, end] = zoomed([0, 0], 0.5, 0, [0, 0]);
  assert.ok(end > start);
});

test("the axis has round times", () => {
  assert.deepEqual(ticks([0, 10], 5), [0, 2, 4, 6, 8, 10]);
  assert.deepEqual(ticks([0.31, 0.42], 3), [0.35, 0.4]);
});

test("the history sorts messages by their use", () => {
  const history = new PanelHistory();
  history.addEvents([
    { t: 1, kind: "move", id: 1, phase: "recorded", type: "movej", program: "start", line: 3 },
    { t: 2, kind: "sio", link: "S\\a", dir: "in", bytes: [65] },
  ]);
  history.addIo({ t: 1, changes: [{ link: "d", value: 1, isLocked: false, isSimulated: false, isProtected: false, fault: null }] });
  history.addState({ t: 1, tasks: [] });
  history.addMotion({ queue: [{ id: 1, leaveDistance: 5 }] });
  assert.deepEqual(history.moves.all().map(({ recorded, hasLeave }) => [recorded, hasLeave]), [[1, true]]);
  assert.equal(history.transfers.length, 1);
  assert.deepEqual(history.signals.of("d"), [[1, 1]]);
  history.clear();
  assert.deepEqual([history.events.length, history.moves.all().length, history.states.length], [0, 0, 0]);
});
