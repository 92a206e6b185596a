import assert from "node:assert/strict";
import { test } from "node:test";
import { firstShown, lanesOf, numberRange, numberTicks } from "../../src/history/lanes";
import type { FromPage } from "../../src/history/messages";
import { HistoryModel } from "../../src/history/model";
import { columnsOf } from "../../src/history/stepLine";
import { placeOf, stepAt, stepsOf } from "../../src/history/steps";
import { columnsOf as tableColumns, TableModel } from "../../src/history/table";
import { counts, DIGITAL, history, inputs, joints, jointTable, NUMBER, points, texts, textTable, write } from "./sample";

const shownBy = (sent: FromPage[] = []): HistoryModel => new HistoryModel((message) => sent.push(message));

test("the values of a history are in chronological order", () => {
  const steps = stepsOf(history("num", NUMBER, [write(1, [5]), write(2, [7])]));
  assert.deepEqual(steps.map(({ t, value, numbers }) => [t, value, numbers]), [[0, "0", [0]], [1, "5", [5]], [2, "7", [7]]]);
  assert.deepEqual([-1, 0, 0.5, 1, 1.5, 9].map((t) => stepAt(steps, t)), [-1, 0, 0, 1, 1, 2]);
  const cut = stepsOf(history("num", NUMBER, [write(1, [5])], { more: true, initial: null, initialNumbers: null, since: null }));
  assert.deepEqual(cut.map(({ t }) => t), [1]);
});

test("the line of a write has its application only if it is another one", () => {
  const places = (application: string): string[] => stepsOf(history("num", NUMBER, [write(1, [5], { source: { application, program: "work", line: 3, file: "" } })])).map((step) => placeOf(step, "main:nCount"));
  assert.deepEqual([places("main"), places("lib")], [["", "work:3"], ["", "lib:work:3"]]);
  assert.deepEqual(stepsOf(inputs()).map((step) => placeOf(step, "io:a")).slice(0, 2), ["", "changed from outside"]);
});

test("all axes of a joint are plotted, and the lengths of a position first", () => {
  assert.deepEqual([...firstShown("joint", joints().series)], [0, 1, 2, 3, 4, 5]);
  assert.deepEqual([...firstShown("point", points().series)], [0, 1, 2]);
  assert.deepEqual(lanesOf(points().series, new Set([0, 4])).map(({ unit, series }) => [unit, series]), [["mm", [0]], ["degrees", [4]]]);
});

test("the scale contains all numbers of the shown time", () => {
  const [lane] = lanesOf(NUMBER, new Set([0]));
  assert.ok(lane);
  const range = (numbers: readonly (number | null)[], shown: readonly [number, number] = [0, 10]): readonly number[] =>
    numberRange(lane, stepsOf(history("num", NUMBER, numbers.map((number, index) => write(index + 1, [number])))), shown);
  assert.deepEqual(range([100, -100]), [-116, 116]);
  assert.deepEqual(range([100, 300], [1.5, 10]), [84, 316], "the number at the left edge counts");
  assert.deepEqual(range([100], [1.5, 10]), [90, 110], "a constant number is in the middle");
  assert.deepEqual(range([null], [1.5, 10]), [0, 1]);
  assert.deepEqual(numberTicks(lane, [0, 2e8], 2).map(({ text }) => text), ["0", "1e8", "2e8"]);
  const [digital] = lanesOf(DIGITAL, new Set([0]));
  assert.ok(digital);
  assert.deepEqual(numberTicks(digital, numberRange(digital, [], [0, 1]), 5).map(({ text }) => text), ["false", "true"]);
});

test("a step line has at most one column for each pixel, and keeps peaks and gaps", () => {
  const many = stepsOf(counts(50_000));
  const columns = columnsOf(many, 0, [0, 10], 600);
  assert.ok(columns.length <= 601, String(columns.length));
  assert.deepEqual([columns[200]?.low, columns[200]?.high], [0, 15]);
  const steps = stepsOf(history("num", NUMBER, [write(1, [5]), write(1.001, [9]), write(1.002, [2]), write(3, [null]), write(4, [1])]));
  assert.deepEqual(columnsOf(steps, 0, [0, 10], 100), [
    { x: 0, low: 0, high: 0, last: 0 }, { x: 10, low: 2, high: 9, last: 2 },
    { x: 30, low: undefined, high: undefined, last: undefined }, { x: 40, low: 1, high: 1, last: 1 },
  ]);
  assert.deepEqual(columnsOf(steps, 0, [2, 2.5], 100), [{ x: 0, low: 2, high: 2, last: 2 }]);
});

test("the newest write stays selected, another one keeps its place", () => {
  const model = shownBy();
  model.take({ kind: "history", history: history("num", NUMBER, [write(1, [5]), write(2, [7])], { now: 3 }) });
  assert.deepEqual([model.selected.value, model.whole.value], [2, [0, 3]]);
  const later = history("num", NUMBER, [write(1, [5]), write(2, [7]), write(4, [8])], { now: 5 });
  model.take({ kind: "history", history: later });
  assert.equal(model.selected.value, 3);
  model.select(1);
  model.take({ kind: "history", history: { ...later, writes: later.writes.slice(0, 2), more: true, initial: null, now: 4.5 } });
  assert.equal(model.selected.value, 1, "the selected write is no longer listed");
  model.take({ kind: "history", history: later });
  model.select(2);
  model.take({ kind: "history", history: history("num", NUMBER, [write(1, [5]), write(2, [7]), write(4, [8]), write(6, [9])], { now: 7 }) });
  assert.equal(model.selected.value, 2);
});

test("after a step back the axis still contains the later time", () => {
  const model = shownBy();
  model.take({ kind: "history", history: history("num", NUMBER, [write(1, [5]), write(2, [7])], { now: 3 }) });
  model.take({ kind: "note", note: "The run continues." });
  model.take({ kind: "history", history: history("num", NUMBER, [write(1, [5])], { now: 1.5 }) });
  assert.deepEqual([model.whole.value, model.history.value?.now, model.note.value], [[0, 3], 1.5, null]);
});

test("the selected write is within the shown time", () => {
  const model = shownBy();
  model.take({ kind: "history", history: counts(90) });
  model.zoom(0.1, 8);
  assert.deepEqual(model.range.value.map((t) => Number(t.toFixed(6))), [7.2, 8.2]);
  model.select(10);
  assert.deepEqual(model.range.value.map((t) => Number(t.toFixed(6))), [0.5, 1.5]);
  model.zoom(100, 5);
  assert.deepEqual(model.range.value, model.whole.value);
});

test("lines are opened, series are hidden, and more writes are requested", () => {
  const sent: FromPage[] = [];
  const model = shownBy(sent);
  model.take({ kind: "history", history: joints() });
  model.toggle(1);
  assert.deepEqual([...model.shown.value], [0, 2, 3, 4, 5]);
  model.take({ kind: "history", history: { ...joints(), now: 12 } });
  assert.equal(model.shown.value.has(1), false, "a hidden axis stays hidden");
  model.open(0, true);
  model.open(1, true);
  model.showEarlier();
  assert.deepEqual(sent, [{ command: "openLine", source: joints().writes.at(-1)?.source, isFinal: true }, { command: "more" }]);
  model.take({ kind: "history", history: texts() });
  assert.deepEqual(model.lanes.value, []);
});

test("a table has a column for each number in the elements, or for the value", () => {
  const cells = (table: ReturnType<typeof jointTable>): string[][] => {
    const columns = tableColumns(table);
    return [columns.map(({ heading }) => heading), ...table.rows.map((row) => columns.map(({ text }) => text(row)))];
  };
  const [heading, first] = cells(jointTable(2));
  assert.deepEqual(heading, ["Index", "j1 (°)", "j2 (°)", "j3 (°)", "j4 (°)", "j5 (°)", "j6 (°)"]);
  assert.deepEqual(first?.slice(0, 3), ["[0]", "0", "0.3333333333"]);
  assert.deepEqual(cells(textTable()), [["Index", "Value"], ["[\"left\"]", "\"<img src=x onerror=alert(1)>\""]]);
  const lengths = { ...jointTable(0), series: [{ name: "", unit: "mm", isDigital: false }], rows: [{ index: "[0]", value: "1e9", numbers: [null] }] };
  assert.deepEqual(cells(lengths), [["Index", "Value (mm)"], ["[0]", "1e9"]]);
  const infinite = { ...jointTable(0), rows: [{ index: "[0]", value: "{inf}", numbers: [null] }] };
  assert.equal(cells(infinite)[1]?.[1], "not finite");
});

test("a table of numbers is plotted over the index", () => {
  const model = new TableModel(() => undefined);
  model.take({ kind: "table", table: jointTable(30) });
  assert.deepEqual([...model.shown.value], [0, 1, 2, 3, 4, 5]);
  assert.deepEqual([model.whole.value, model.steps.value.length, model.present.value], [[0, 29], 30, undefined]);
  assert.deepEqual(model.axis.ticks([0, 29], 3).map(({ at, text }) => [at, text]), [[0, "[0]"], [10, "[10]"], [20, "[20]"]]);
  assert.deepEqual(model.axis.ticks([0, 1], 5).map(({ text }) => text), ["[0]", "[1]"], "between two elements there is no mark");
  assert.deepEqual([0.4, 0.6, 29].map((position) => model.indexAt(position)), [0, 1, 29], "the nearest element");
  model.select(3);
  assert.match(model.describe(model.steps.value[3] ?? assert.fail(), true), /^\[3\], \{/);
  model.take({ kind: "table", table: { ...jointTable(30), type: "point[30]", series: points().series } });
  assert.deepEqual([...model.shown.value], [0, 1, 2], "the lengths of a position first");
  model.take({ kind: "table", table: textTable() });
  assert.deepEqual([model.shown.value.size, model.lanes.value.length], [0, 0]);
});

test("a table shows its newest elements, and requests more", () => {
  const sent: FromPage[] = [];
  const model = new TableModel((message) => sent.push(message));
  model.take({ kind: "note", note: "The run continues." });
  model.take({ kind: "history", history: joints() });
  assert.deepEqual([model.table.value, model.note.value], [undefined, "The run continues."]);
  model.take({ kind: "table", table: jointTable(3) });
  assert.deepEqual([model.table.value?.count, model.note.value], [3, null]);
  model.showMore();
  assert.deepEqual(sent, [{ command: "more" }]);
});
