import assert from "node:assert/strict";
import { test } from "node:test";
import type { CellState } from "../../src/panels/shared/cell";
import type { TaskState } from "../../src/panels/tasks/chart";
import { type StatusFacts, statusOf } from "../../src/status/status";
import { conditionOf, waitsText } from "../../src/status/waits";

const task = (name: string, fields: Partial<TaskState> = {}): TaskState =>
  ({ name, state: "running", program: "start", line: 12, file: "start.pgx", priority: 10, period: null, overruns: 0, error: null, waits: null, ...fields });
const state = (tasks: TaskState[], fields: Partial<CellState> = {}): CellState =>
  ({ tasks, power: true, mode: "remote", emergencyStop: "none", isHeld: false, awaitedHold: null, monitorSpeed: 100, ...fields });
const facts = (fields: Partial<StatusFacts>): StatusFacts =>
  ({ lost: undefined, end: undefined, role: "operator", isPast: false, isPaused: false, isStopped: false, isSilent: false, awaited: undefined, isInEditor: false, state: state([task("start")]), ...fields });

test("the first reason that keeps the run from going on is shown", () => {
  const waiting = task("pick", { waits: "the arm (`movej`), which has no power: call enablePower()", awaits: "the arm (`movej`)" });
  const failed = task("a", { error: 20, state: "error" });
  const moving = task("pick", { waits: "the arm (`waitEndMove`)", awaits: "the arm (`waitEndMove`)" });
  const unpowered = task("a", { waits: "a condition", awaits: "a condition", lineCode: "wait(isPowered())" });
  const delayed = task("host", { waits: "time (`delay`)", awaits: "time (`delay`)" });
  const held = state([delayed, waiting], { power: false, awaitedHold: "The arm has no power. Switch the power on." });
  for (const [fields, kind, text] of [
    [{}, "running", "Running."],
    [{ lost: "The connection to the run is lost." }, "fault", "The connection to the run is lost."],
    [{ role: undefined }, "stopped", "The run has not begun."],
    [{ end: "finished" }, "stopped", "The run has ended: finished. Press Run to start the application again."],
    [{ end: "finished", role: "guest" }, "stopped", "The run has ended: finished."],
    [{ isPast: true }, "stopped", "You are looking at the past."],
    [{ isPast: true, role: "recording" }, "running", "Running."],
    [{ isPaused: true }, "stopped", "The run is paused. Press Play to continue."],
    [{ isStopped: true }, "stopped", "The debugger has stopped the run."],
    [{ isSilent: true }, "fault", "No answer from the server for 3 s. It is stopped or overloaded."],
    [{ isSilent: true, end: "finished", role: "guest" }, "stopped", "The run has ended: finished."],
    [{ isPaused: true, role: "debugger" }, "stopped", "The debugger has stopped the run."],
    [{ state: held }, "stopped", "The arm has no power. Switch the power on. pick waits for the arm (movej) at start:12."],
    [{ state: state([task("a")], { isHeld: true, heldBecause: "The arm is held. Press Move." }) }, "stopped", "The arm is held. Press Move. Running."],
    [{ state: state([task("a")], { isHeld: true }) }, "running", "Running. The arm is held. Press Move."],
    [{ state: state([task("a", { waits: "a condition" })], { isHeld: true, mode: "manual" }) }, "waiting", "a waits for a condition at start:12. Held in manual mode."],
    [{ state: state([task("a", { waits: "a condition" })], { awaitsNextMove: true }) }, "waiting", "a waits for a condition at start:12. The arm waits for the next move."],
    [{ state: state([waiting], { emergencyStop: "open" }) }, "stopped", "The E-stop is pressed. Release it, then switch the power on."],
    [{ state: state([task("a", { waits: "a condition" })]) }, "waiting", "a waits for a condition at start:12."],
    [{ state: state([task("a", { waits: "a condition" }), task("b")]) }, "running", "Running."],
    [{ isPast: true, awaited: 3 }, "waiting", "The run at 3.0 s is still being loaded. Until then, the oldest loaded time is shown."],
    [{ role: undefined, isInEditor: true }, "stopped", "No application is shown. Open one of its files in the editor."],
    [{ state: state([failed]) }, "fault", "a has failed with error 20 at start:12. Press Run to start the application again."],
    [{ state: state([failed, { ...failed, name: "b" }]), role: "debugger" }, "fault", "All tasks have failed. Restart the application in the editor."],
    [{ state: state([failed]), role: "recording" }, "fault", "a has failed with error 20 at start:12."],
    [{ state: state([failed, task("b")]) }, "fault", "a has failed with error 20 at start:12. Running."],
    [{ state: state([failed, waiting], { power: false, awaitedHold: "The arm has no power." }) }, "fault", "a has failed with error 20 at start:12. The arm has no power. pick waits for the arm (movej) at start:12."],
    [{ state: state([moving]) }, "running", "The arm moves. pick waits for the arm (waitEndMove) at start:12."],
    [{ state: state([unpowered], { power: false }) }, "stopped", "The arm has no power. Switch the power on. a waits for isPowered() at start:12."],
    [{ state: state([unpowered]) }, "waiting", "a waits for isPowered() at start:12."],
    [{ state: state([{ ...unpowered, lineCode: "wait(!isPowered())" }], { power: false }) }, "waiting", "a waits for !isPowered() at start:12."],
    [{ state: state([]) }, "stopped", "No task exists."],
  ] as const) {
    const status = statusOf(facts(fields));
    assert.deepEqual([status.kind, status.text], [kind, text]);
  }
});

test("the most important waits come first", () => {
  const time = { waits: "time (`delay`)", awaits: "time (`delay`)" };
  const tasks = [
    task("sensors", { ...time, priority: 90 }), task("log", time), task("arm", { waits: "the arm (`movej`)", awaits: "the arm (`movej`)" }),
    task("low", { waits: "a condition", awaits: "a condition", priority: 5, lineCode: "wait(io:diPart==true) // a part" }),
    task("high", { waits: "the operator (`get`)", awaits: "the operator (`get`)", priority: 50 }),
  ];
  assert.equal(waitsText(tasks), "high waits for the operator (get) at start:12; low waits for io:diPart==true at start:12; and 3 more.");
  assert.equal(waitsText(tasks.slice(0, 3)), "arm waits for the arm (movej) at start:12; sensors waits for time (delay) at start:12; and 1 more.");
  assert.deepEqual(["wait(a(1) and b)", "WAIT ( x )", "watch(a,2)", null].map(conditionOf), ["a(1) and b", "x", undefined, undefined]);
});

test("two waiting tasks are named, others are counted", () => {
  const tasks = ["a", "b", "c"].map((name) => task(name, { waits: "time (`delay`)" }));
  assert.equal(waitsText(tasks), "a waits for time (delay) at start:12; b waits for time (delay) at start:12; and 1 more.");
  assert.equal(waitsText([task("a")]), "");
});
