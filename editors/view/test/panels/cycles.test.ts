import assert from "node:assert/strict";
import test from "node:test";
import { SignalHistory } from "../../src/panels/io/sparkline";
import { TaskSegments } from "../../src/panels/tasks/chart";
import { cyclesOf, moverOf, repeatedEvents, summaryOf } from "../../src/panels/tasks/cycles";
import type { RunEvent } from "../../src/panels/tasks/eventText";
import { Moves } from "../../src/panels/tasks/moves";

test("moves and digital signals that repeat are events of cycles", () => {
  const moves = new Moves();
  const start = (id: number, line: number, t: number): void => moves.add({ t, id, phase: "started", type: "movej", program: "pick", line });
  [[1, 7, 2], [2, 8, 3], [3, 7, 6], [4, 7, 9]].forEach(([id = 0, line = 0, t = 0]) => start(id, line, t));
  const signals = new SignalHistory();
  [[0, 1], [1.5, 0], [2.5, 1], [3, 0], [7, 1], [12, 0], [13, 1]].forEach(([t = 0, value = 0]) => signals.add("valve1", t, value));
  [[0, 0], [1, 3], [2, 0], [3, 4]].forEach(([t = 0, value = 0]) => signals.add("aiWeight", t, value));
  assert.deepEqual(repeatedEvents(moves.all(), [{ link: "valve1", isDigital: true }, { link: "aiWeight", isDigital: false }], signals, 10), [
    { name: "Move in pick:7", times: [2, 6, 9] },
    { name: "valve1 becomes true", times: [2.5, 7] },
  ]);
});

test("the parts of a cycle are the motion of the arm and the waits of its task while it rests", () => {
  const tasks = new TaskSegments();
  const state = (t: number, waits: string | null): void => tasks.add(t, [{
    name: "work", state: waits === null ? "running" : "waiting", waits, program: "work", line: 3, file: "work.pgx", priority: 10, period: null, overruns: 0, error: null,
  }]);
  state(0, "the arm (`waitEndMove`)");
  state(4, "a condition");
  state(6, "time (`delay`)");
  state(7, null);
  state(8, "the arm (`waitEndMove`)");
  state(11, "a condition of the arm, which has no power");
  // The arm rests while the task waits for a condition and for time, and from 11 s on.
  const cycles = cyclesOf([1, 9, 13], [{ start: 0, end: 0.5 }, { start: 4, end: 7.5 }, { start: 11, end: Infinity }], tasks.of("work"));
  assert.deepEqual(cycles, [
    { from: 1, to: 9, moving: 4.5, outside: 2, arm: 0, time: 1, other: 0.5 },
    { from: 9, to: 13, moving: 2, outside: 0, arm: 2, time: 0, other: 0 },
  ]);
  assert.deepEqual(summaryOf(cycles), { count: 2, first: 8, min: 4, mean: 6, max: 8, moving: 3.25, outside: 1, arm: 1, time: 0.5, other: 0.25 });
  assert.equal(summaryOf([]), undefined);
});

test("the task that moves the arm has recorded the last move", () => {
  const event = (fields: object): RunEvent => ({ t: 0, kind: "move", ...fields });
  assert.equal(moverOf([event({ phase: "recorded", task: "work" }), event({ phase: "started" }), event({ kind: "print", task: "main" })]), "work");
  assert.equal(moverOf([]), undefined);
});
