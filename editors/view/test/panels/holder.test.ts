import assert from "node:assert/strict";
import { test } from "node:test";
import { signal } from "@preact/signals";
import { Holder, type Step } from "../../src/panels/pendant/Holder";
import { goStep } from "../../src/panels/pendant/jogSteps";
import { pressNow } from "../../src/panels/pendant/stopNow";
import { startAgain } from "../../src/panels/pendant/startAgain";
import { armEndReason, endReason, hasFailed, nextSpeed, jogReason, powerReason, runReason, speedFrom, stopText } from "../../src/panels/pendant/robotState";
import { type Answer, type Cell, type CellState, Notice } from "../../src/panels/shared/cell";

const STATE: CellState = { tasks: [], power: true, mode: "manual", emergencyStop: "none", isHeld: true, monitorSpeed: 50 };
const PLUS: Step = ([joint = 0]) => (joint >= 20 ? { refusal: "Axis 1 is at its limit." } : { joints: [joint + 10] });

function bench(answer: Answer = { error: null }): { cell: Cell; sent: unknown[]; arm: (joint: number) => void } {
  const sample = signal({ joints: [0], tool: [] });
  const sent: unknown[] = [];
  const send = (_: string, args: object): Promise<Answer> => {
    sent.push(args);
    return Promise.resolve(answer);
  };
  const cell = { sample, blocked: signal<string | undefined>(undefined), send } as unknown as Cell;
  return { cell, sent, arm: (joint) => (sample.value = { joints: [joint], tool: [] }) };
}

test("a held button adds steps while the arm follows, up to the limit", (context) => {
  context.mock.timers.enable({ apis: ["setInterval"] });
  const { cell, sent, arm } = bench();
  const notice = new Notice();
  const holder = new Holder(cell, notice);
  holder.hold(PLUS);
  context.mock.timers.tick(150);
  assert.deepEqual(sent, [{ keys: { jog: [10] } }, { keys: { jog: [20] } }]);
  arm(20);
  context.mock.timers.tick(600);
  assert.equal(sent.length, 2);
  assert.equal(notice.text.value, "Axis 1 is at its limit.");
});

test("the end of a way is silent, and a way that has no length is not", (context) => {
  context.mock.timers.enable({ apis: ["setInterval"] });
  const { cell, sent, arm } = bench();
  const notice = new Notice();
  const holder = new Holder(cell, notice);
  holder.hold(goStep([7]));
  context.mock.timers.tick(150);
  arm(7);
  context.mock.timers.tick(600);
  assert.deepEqual([sent.length, notice.text.value], [2, ""]);
  holder.hold(goStep([7]));
  assert.deepEqual([sent.length, notice.text.value], [2, "The arm is there."]);
});

test("a released button adds no step", (context) => {
  context.mock.timers.enable({ apis: ["setInterval"] });
  const { cell, sent } = bench();
  const holder = new Holder(cell, new Notice());
  holder.hold(PLUS);
  holder.release();
  context.mock.timers.tick(600);
  assert.equal(sent.length, 1);
});

test("a refusal is shown as a sentence", async () => {
  const { cell } = bench({ error: "The arm is moving." });
  const notice = new Notice();
  assert.equal(await notice.operate(cell, { power: true }), undefined);
  assert.equal(notice.text.value, "The arm is moving.");
});

test("nothing is sent where operating is impossible", async () => {
  const { cell, sent } = bench();
  const notice = new Notice();
  await notice.operate({ ...cell, blocked: signal("This is a recording.") }, { power: true });
  assert.deepEqual([sent, notice.text.value], [[], "This is a recording."]);
});

test("the speed keys go through round values", () => {
  assert.deepEqual([nextSpeed(50, 1), nextSpeed(53, 1), nextSpeed(53, -1), nextSpeed(100, 1), nextSpeed(0, -1), nextSpeed(1, -1)], [60, 60, 50, 100, 0, 0]);
  assert.deepEqual(["50", " 0.5 ", "", "101", "-1", "x"].map(speedFrom), [50, 0.5, undefined, undefined, undefined, undefined]);
});

test("reasons say what the operator has to do first", () => {
  assert.equal(jogReason(STATE, undefined), undefined);
  assert.equal(jogReason({ ...STATE, mode: "remote" }, undefined), "Choose the manual working mode to jog.");
  assert.equal(jogReason({ ...STATE, power: false }, undefined), "Switch the power on to jog.");
  assert.equal(powerReason({ ...STATE, power: false, emergencyStop: "open" }), "Release the E-stop before you switch the power on.");
  assert.equal(powerReason({ ...STATE, power: false, emergencyStop: "released" }), undefined);
  assert.match(stopText({ ...STATE, emergencyStop: "released" }), /acknowledge/);
  assert.deepEqual([runReason(true, false, true), runReason(false, false, true)], ["The run is paused. Press Play to continue.", "The application is running."]);
  assert.equal(runReason(true, false, false), "The debugger has stopped the run. Continue in the editor.");
  assert.deepEqual([runReason(false, true, true), runReason(false, true, false)], [undefined, "The run is over. Start it again in the editor."]);
  const ended = "The run has ended. Press Run to start the application again.";
  assert.deepEqual([endReason(false, true), endReason(true, true), endReason(true, false)], [undefined, ended, "The run has ended."]);
  assert.equal(jogReason({ ...STATE, mode: "remote" }, ended), ended, "another mode does not help");
  assert.deepEqual([undefined, "finished", "stopped", "limit"].map((end) => armEndReason(end, true)), [undefined, undefined, undefined, ended]);
  assert.equal(armEndReason("finished", false), "The run has ended.", "the server of a debugger ends with its run");
});

test("Run ends an application whose tasks have all failed, then starts it again", async () => {
  const { cell, sent } = bench();
  const task = { name: "start", state: "error", program: "start", line: 5, file: "start.pgx", priority: 10, period: null, overruns: 0, error: 20, waits: null };
  assert.deepEqual([hasFailed({ ...STATE, tasks: [task] }), hasFailed({ ...STATE, tasks: [task, { ...task, error: null }] }), hasFailed({ ...STATE, tasks: [] })], [true, false, false]);
  const hasEnded = signal(false);
  const started = startAgain({ ...cell, hasEnded, isPaused: signal(true) }, new Notice(), "stays");
  await new Promise((resolve) => setTimeout(resolve));
  assert.deepEqual(sent, [{ keys: { stop: true } }, { isPaused: false }]);
  hasEnded.value = true;
  await started;
  assert.deepEqual(sent.slice(2), [{}]);
  await startAgain({ ...cell, hasEnded }, new Notice(), "initial");
  assert.deepEqual(sent.slice(3), [{ atInitialPosition: true }]);
});

test("a stop while the page shows the past acts on the present", async () => {
  const { cell, sent } = bench();
  const blocked = signal<string | undefined>("You are looking at the past.");
  const notice = new Notice();
  await pressNow({ ...cell, blocked, showPresent: () => (blocked.value = undefined) }, notice, { estop: true }, "The E-stop was pressed.");
  assert.deepEqual([sent, notice.text.value], [[{ keys: { estop: true } }], "The E-stop was pressed. The page shows the present again."]);
});
