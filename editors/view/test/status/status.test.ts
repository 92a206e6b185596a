import assert from "node:assert/strict";
import { test } from "node:test";
import type { CellState } from "../../src/panels/shared/cell";
import type { TaskState } from "../../src/panels/tasks/chart";
import { type StatusFacts, statusOf, waitsText } from "../../src/status/status";

const task = (name: string, fields: Partial<TaskState> = {}): TaskState =>
  ({ name, state: "running", program: "start", line: 12, file: "start.pgx", priority: 10, period: null, overruns: 0, error: null, waits: null, ...fields });
const state = (tasks: TaskState[], fields: Partial<CellState> = {}): CellState =>
  ({ tasks, power: true, mode: "remote", emergencyStop: "none", isHeld: false, awaitedHold: null, monitorSpeed: 100, ...fields });
const facts = (fields: Partial<StatusFacts>): StatusFacts =>
  ({ lost: undefined, end: undefined, role: "operator", isPast: false, isPaused: false, isStopped: false, isSilent: false, state: state([task("start")]), ...fields });

test("the first reason that keeps the run from going on is shown", () => {
  const waiting = task("pick", { waits: "the arm (`movej`), which has no power: call enablePower()", awaits: "the arm (`movej`)" });
  const delayed = task("host", { waits: "time (`delay`)", awaits: "time (`delay`)" });
  const held = state([delayed, waiting], { power: false, awaitedHold: "The arm has no power. Press Power to switch it on." });
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
    [{ state: held }, "stopped", "The arm has no power. Press Power to switch it on. pick waits for the arm (movej) at start:12."],
    [{ state: state([waiting], { emergencyStop: "open" }) }, "stopped", "The E-stop is pressed. Release it, then switch the power on."],
    [{ state: state([task("a", { waits: "a condition" })]) }, "waiting", "a waits for a condition at start:12."],
    [{ state: state([task("a", { waits: "a condition" }), task("b")]) }, "running", "Running."],
    [{ state: state([task("a", { error: 20, state: "error" })]) }, "fault", "All tasks have failed."],
    [{ state: state([]) }, "stopped", "No task exists."],
  ] as const) {
    const status = statusOf(facts(fields));
    assert.deepEqual([status.kind, status.text], [kind, text]);
  }
});

test("two waiting tasks are named, others are counted", () => {
  const tasks = ["a", "b", "c"].map((name) => task(name, { waits: "time (`delay`)" }));
  assert.equal(waitsText(tasks), "a waits for time (delay) at start:12; b waits for time (delay) at start:12; and 1 more.");
  assert.equal(waitsText([task("a")]), "");
});
