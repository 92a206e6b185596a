import assert from "node:assert/strict";
import { test } from "node:test";
import { type TaskState, TaskSegments, visible, waitTotals } from "../../src/panels/tasks/chart";
import { GROUPS, groupOf, rowClass, shownEvents, textOf } from "../../src/panels/tasks/eventText";
import { cutBlends, cutText, Moves, type MoveTimes, waitsInMoves } from "../../src/panels/tasks/moves";
import { ArmTimes, share, taskTimes, type TimedPhase, type TimedPhases } from "../../src/panels/tasks/times";

function task(name: string, state: string, waits: string | null = null, line = 1): TaskState {
  return { name, state, program: name, line, file: "", priority: 10, period: null, overruns: 0, error: null, waits };
}

function segments(): TaskSegments {
  const lanes = new TaskSegments();
  lanes.add(0, [task("main", "running"), task("io", "waiting", "time (`delay`)")]);
  lanes.add(1, [task("main", "running", null, 7), task("io", "waiting", "time (`delay`)")]);
  lanes.add(2, [task("main", "waiting", "the arm (`waitEndMove`)"), task("io", "running")]);
  lanes.add(5, [task("main", "running")]);
  return lanes;
}

test("a segment lasts as long as a task is in one state", () => {
  const lanes = segments();
  assert.deepEqual(lanes.of("main").map(({ start, end, state }) => [start, end, state]), [[0, 2, "running"], [2, 5, "waiting"], [5, Infinity, "running"]]);
  assert.deepEqual(lanes.of("io").map(({ start, end }) => [start, end]), [[0, 2], [2, 5]]);
});

test("short segments are joined in the chart", () => {
  const lane = Array.from({ length: 1000 }, (_, at) => ({ start: at / 1000, end: (at + 1) / 1000, state: "running", waits: null, program: "", line: 1, file: "" }));
  assert.ok(visible(lane, 0, 1, 100).length <= 100);
  assert.deepEqual(visible(segments().of("main"), 1, 3, 100).map(({ x, w }) => [x, w]), [[0, 50], [50, 50]]);
});

test("waits are summed, the longest first", () => {
  assert.deepEqual(waitTotals(segments(), 1, 4).map(({ task, seconds, count }) => [task, seconds, count]), [["main", 2, 1], ["io", 1, 1]]);
});

test("a blend that did not happen is found with its reason", () => {
  const moves = new Moves();
  const add = (t: number, id: number, phase: string): void => moves.add({ t, id, phase, type: "movel", program: "start", line: id });
  [1, 2].forEach((id) => add(0, id, "recorded"));
  [1, 2].forEach((id) => moves.addQueued({ id, leaveDistance: 10 }));
  add(1, 1, "blend");
  add(2, 1, "done");
  add(3, 2, "done");
  add(3.5, 3, "recorded");
  const cuts = cutBlends(moves.all(), 10);
  assert.deepEqual(cuts.map(({ move, delay }) => [move.id, delay]), [[2, 0.5]]);
  assert.equal(cuts.map(cutText).join(), "movel at start:2 stopped at its target: the next move was recorded 0.500 s after its end.");
  assert.deepEqual(cutBlends(moves.all(), 2.5), []);
  assert.equal(cutBlends(moves.all(), 3.2)[0]?.delay, undefined);
});

test("times of tasks are counted from one state to the next", () => {
  const states = [
    { t: 0, tasks: [task("main", "running", null, 3)] },
    { t: 1, tasks: [task("main", "waiting", "a condition", 4)] },
    { t: 4, tasks: [task("main", "running", null, 3)] },
  ];
  assert.deepEqual(taskTimes(states, 4.5).map(({ line, activity, seconds }) => [line, activity, seconds]), [[4, "a condition", 3], [3, "computing", 1.5]]);
  assert.deepEqual(taskTimes(states, 0.5).map(({ seconds }) => seconds), [0.5]);
});

/** Phases that count how many of them were read. */
function phasesOf(samples: readonly TimedPhase[]): TimedPhases & { read: number; number: number } {
  return {
    read: 0,
    number: 0,
    epoch() { return this.number; },
    *after(t) {
      for (const sample of samples.filter((candidate) => candidate.t > t)) {
        this.read += 1;
        yield sample;
      }
    },
  };
}

test("times of the arm are counted by phase and line", () => {
  const source = { program: "start", line: 5 };
  const samples = [
    { t: 1.004, phase: "nominal", source }, { t: 1.008, phase: "nominal", source }, { t: 1.012, phase: "blend", source },
    { t: 2, phase: "waiting", source }, { t: 3, phase: "waiting", source: undefined },
  ];
  const rows = new ArmTimes(phasesOf(samples)).between(0, 4).map(({ line, activity, seconds }) => [line, activity, Number(seconds.toFixed(3))]);
  assert.deepEqual(rows, [[0, "no move", 2.004], [5, "waiting for the next move", 1], [5, "blend", 0.988], [5, "nominal", 0.008]]);
  assert.equal(share(1, 4), "25.0 %");
});

test("each sample is counted once while time advances, and again after samples were discarded", () => {
  const source = { program: "start", line: 5 };
  const samples = Array.from({ length: 400 }, (_, index) => ({ t: index * 0.01, phase: index % 7 === 0 ? "blend" : "nominal", source }));
  const phases = phasesOf(samples);
  const counter = new ArmTimes(phases);
  const rounded = (rows: ReturnType<ArmTimes["between"]>): unknown[] => rows.map(({ activity, seconds }) => [activity, Number(seconds.toFixed(6))]);
  for (const end of [0.5, 1.234, 1.234, 3, 3.99]) {
    assert.deepEqual(rounded(counter.between(0, end)), rounded(new ArmTimes(phasesOf(samples)).between(0, end)), `${end}`);
  }
  assert.ok(phases.read <= samples.length + 5, `${phases.read} samples were read`);
  const back = (end: number): void => assert.deepEqual(rounded(counter.between(0, end)), rounded(new ArmTimes(phasesOf(samples)).between(0, end)));
  back(0.7);
  samples.splice(0, samples.length, { t: 0.3, phase: "stopping", source });
  phases.number += 1;
  back(3.99);
  assert.deepEqual(rounded(counter.between(0, 4)).length, 2);
});

test("every kind of event has a text and a group", () => {
  const move = { t: 1, kind: "move", id: 4, phase: "done", type: "movej", program: "start", line: 9 };
  assert.equal(textOf(move), "movej 4 done at start:9");
  assert.equal(groupOf({ ...move, phase: "error" }), "errors");
  assert.equal(textOf({ t: 0, kind: "sio", link: "S\\a", dir: "in", bytes: [1, 2] }), "S\\a received 2 bytes");
  assert.equal(textOf({ t: 0, kind: "novelty", size: 3 }), "novelty size: 3");
});

test("the log is filtered by group and words", () => {
  const events = [{ t: 0, kind: "print", text: "Hello <b>" }, { t: 1, kind: "power", on: true }, { t: 2, kind: "error", code: 60, program: "a", line: 1, message: "m" }];
  const all = new Set(GROUPS.map(([group]) => group));
  assert.equal(shownEvents(events, { groups: all, text: "" }).length, 3);
  assert.deepEqual(shownEvents(events, { groups: all, text: "hello <B>" }).map(({ t }) => t), [0]);
  assert.deepEqual(shownEvents(events, { groups: new Set(["errors"]), text: "" }).map(({ t }) => t), [2]);
  assert.equal(textOf({ t: 1, kind: "grip", gripper: "tCup", part: "box[0]", nearest: "box[0]", distance: 0, within: 5 }), "tCup grips box[0]");
  assert.equal(textOf({ t: 1, kind: "grip", gripper: "tCup", part: null, nearest: "box[0]", distance: 12.34, within: 5 }), "tCup grips nothing: no part within 5 mm; box[0] is 12.3 mm away");
  assert.equal(textOf({ t: 1, kind: "release", gripper: "tCup", part: "box[0]", above: 312.4 }), "tCup releases box[0], 312 mm above everything below it");
  assert.equal(textOf({ t: 1, kind: "part", part: "box[0]", state: "removed" }), "box[0] removed");
  assert.equal(textOf({ t: 1, kind: "sensor", sensor: "stop", on: true, detects: "box[0]" }), "stop detects box[0]");
  assert.equal(textOf({ t: 1, kind: "act", keys: { key: "F1" } }), `from outside: {"key":"F1"}`);
});

test("the arm waits within a move while it has no samples", () => {
  const move = (id: number, started: number, done: number | undefined): MoveTimes => ({ id, type: "movel", program: "start", line: 1, recorded: started, started, blend: undefined, done, hasLeave: false });
  const rests = [{ start: 0, end: 1 }, { start: 3, end: 3.1 }, { start: 5, end: 6 }, { start: 8, end: Infinity }];
  const waits = waitsInMoves(rests, [move(1, 1, 4), move(2, 4.5, 7), move(3, 7.5, undefined)], 10);
  assert.deepEqual(waits, [{ start: 5, end: 6 }, { start: 8, end: Infinity }]);
  assert.deepEqual(waitsInMoves(rests, [], 10), []);
});

test("rows of the event log show the level of messages", () => {
  const log = (level: string): string => rowClass({ t: 1, kind: "log", level, text: "USR done" });
  assert.deepEqual([log("info"), log("warning"), log("error"), rowClass({ t: 1, kind: "print", text: "x" })], ["messages log info", "messages log warning", "errors log error", "messages"]);
});
