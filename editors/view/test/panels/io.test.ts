import assert from "node:assert/strict";
import { test } from "node:test";
import { asHex, asText, lastTransfers } from "../../src/panels/io/lineBytes";
import { forceKeys, levelText, longestName, nameOf, numberFrom, placeOf, rowsOf, type SignalFilter, type SignalInfo, type SignalState, sorted } from "../../src/panels/io/signalRows";
import { SignalHistory, sparkPath, within } from "../../src/panels/io/sparkline";

function signal(link: string, more: Partial<SignalInfo> = {}): SignalInfo {
  return { link, names: [], board: "", direction: "input", isDigital: true, unit: null, ...more };
}

const SIGNALS = sorted([
  signal("B-1\\%I10"), signal("B-1\\%I2", { names: ["diGripper"] }),
  signal("B-1\\%Q1", { direction: "output" }), signal("A\\w", { isDigital: false, unit: "kg" }),
]);
const ALL: SignalFilter = { text: "", direction: "all", isMarkedOnly: false };
const FREE: SignalState = { value: 0, isLocked: false, isSimulated: false, isProtected: false, fault: null };

function shown(filter: Partial<SignalFilter>, states: Record<string, SignalState> = {}): string[] {
  const rows = rowsOf(SIGNALS, { ...ALL, ...filter }, (link) => states[link]);
  return rows.map((row) => ("board" in row ? `${row.board}: ${row.count}` : row.signal.link));
}

test("signals are sorted by board and number", () => {
  assert.deepEqual(shown({}), ["A: 1", "A\\w", "B-1: 3", "B-1\\%I2", "B-1\\%I10", "B-1\\%Q1"]);
});

test("the filter finds links and names of data", () => {
  assert.deepEqual(shown({ text: "GRIP b-1" }), ["B-1: 1", "B-1\\%I2"]);
  assert.deepEqual(shown({ direction: "output" }), ["B-1: 1", "B-1\\%Q1"]);
  assert.deepEqual(shown({ isMarkedOnly: true }, { "A\\w": { ...FREE, fault: "broken" }, "B-1\\%I2": FREE }), ["A: 1", "A\\w"]);
  assert.deepEqual(shown({ text: "nothing" }), []);
});

test("values have units and are read from texts", () => {
  assert.equal(levelText(signal("w", { isDigital: false, unit: "kg" }), 3.14159), "3.142 kg");
  assert.equal(levelText(signal("d"), 1), "true");
  assert.deepEqual(["1.5", " 2,5 ", "", "x", "1e999"].map(numberFrom), [1.5, 2.5, undefined, undefined, undefined]);
});

test("a locked signal takes its value from its lock", () => {
  assert.deepEqual(forceKeys(signal("d"), 1, false), { io: { d: true } });
  assert.deepEqual(forceKeys(signal("a", { isDigital: false }), 2.5, true), { lock: { a: 2.5 } });
});

test("a sparkline shows the last ten seconds", () => {
  const history = new SignalHistory();
  [[0, 0], [1, 1], [2, 1], [15, 0], [18, 1]].forEach(([t = 0, value = 0]) => history.add("d", t, value));
  assert.deepEqual(within(history.of("d"), 10, 20), [[1, 1], [15, 0], [18, 1]]);
  assert.equal(sparkPath(history.of("d"), 20, true), "M0.0 3.0H48.0V15.0H76.8V3.0H96");
  assert.equal(sparkPath(history.of("d"), 0.5, true), "M91.2 15.0H96");
  assert.equal(sparkPath(history.of("unknown"), 20, true), "");
});

test("bytes are shown as text and in hexadecimal", () => {
  assert.equal(asText([79, 75, 13, 10, 60]), "OK<0d><0a><");
  assert.equal(asHex([0, 255]), "00 ff");
  assert.ok(asText(Array<number>(100).fill(65)).startsWith("…AAA"));
});

test("the newest transfers of a line come first, none from the future", () => {
  const transfers = [1, 2, 3].map((t) => ({ t, link: t === 2 ? "b" : "a", dir: "in" as const, bytes: [t] }));
  assert.deepEqual(lastTransfers(transfers, "a", 3, 5).map(({ t }) => t), [3, 1]);
  assert.deepEqual(lastTransfers(transfers, "a", 2.5, 5).map(({ t }) => t), [1]);
});

test("a signal has the names of its data, otherwise its address", () => {
  const named = signal("Board\\%I4", { names: ["io:diClear", "diClear"] });
  const other = signal("Board\\%Q5", { names: [], direction: "output" });
  assert.deepEqual([named, other].map(nameOf), ["io:diClear, diClear", "%Q5"]);
  assert.deepEqual([named, other].map(placeOf), ["%I4 in", "out"]);
  assert.equal(longestName([other, named]), "io:diClear, diClear %I4 in".length);
});
