import assert from "node:assert/strict";
import { test } from "node:test";
import { signal } from "@preact/signals";
import type { MovingLine } from "../../src/panels/program/marks";
import type { ArmSample, Cell } from "../../src/panels/shared/cell";
import type { SceneMessage, StateMessage } from "../../src/panels/shared/messages";
import { PanelModel, type Surroundings } from "../../src/panels/shared/PanelModel";
import { throttled } from "../../src/panels/shared/throttled";

const SCENE: SceneMessage = {
  arm: { axes: [], links: [], flange: [] }, base: [], frames: [], signals: [], lines: [],
  points: [{ name: "pA", key: null, father: null, local: [1], pose: [1] }],
};

function state(t: number, more: Partial<StateMessage> = {}): StateMessage {
  return { t, tasks: [], power: false, mode: "remote", emergencyStop: "none", isHeld: false, monitorSpeed: 100, ...more };
}

function model(executed = signal<MovingLine | undefined>(undefined)): { model: PanelModel; cell: Cell; show: (t: number) => void } {
  const time = signal(0);
  const around: Surroundings = {
    time, newest: signal(10), oldest: signal(0), isPaused: signal(false), hasEnded: signal(false), armEnded: signal(undefined), isPastOnly: signal(false), showPresent: () => undefined, canRestart: signal(true), blocked: signal(undefined),
    sample: signal<ArmSample | undefined>(undefined), samples: { after: () => [], epoch: () => 0 }, rests: () => [], toolOf: (index) => (index === 2 ? "tGripper" : undefined), sourceOf: (index) => (index === 3 ? { program: "start", line: 12, file: "/cell/start.pgx" } : undefined),
    applicationName: signal("cell"), executed, showPrograms: () => undefined,
    seek: (t) => (time.value = t), selectedPoint: signal(undefined), selectPoint: () => undefined, openLine: signal(undefined), send: () => Promise.resolve({ error: null }),
  };
  const made = new PanelModel(around);
  made.addScene(SCENE);
  return { model: made, cell: made.cell, show: (t) => (time.value = t) };
}

test("the parts are at their places of the shown time", () => {
  const { model: panels, cell, show } = model();
  const part = (t: number, carrier: "world" | "flange"): void => panels.add({ kind: "parts", t, parts: [{ name: "box[0]", carrier: { kind: carrier }, pose: [0, 0, 0, 0, 0, 0] }] });
  part(0, "world");
  part(2.6, "flange");
  part(5.1, "world");
  const carrierAt = (t: number): string | undefined => {
    show(t);
    return cell.parts.value[0]?.carrier?.kind;
  };
  assert.deepEqual([1, 3, 6].map(carrierAt), ["world", "flange", "world"]);
  panels.clear();
  assert.equal(carrierAt(3), undefined);
});

test("the panels show the state and the page of the shown time", (context) => {
  context.mock.timers.enable({ apis: ["setTimeout"] });
  const { model: panels, cell, show } = model();
  panels.add({ kind: "state", ...state(1) });
  panels.add({ kind: "state", ...state(2, { power: true }) });
  panels.add({ kind: "motion", t: 2, path: [], queue: [{ id: 7, type: "movej", source: 3, phase: "nominal", target: [], leave: null, reach: null, leaveDistance: null, reachDistance: null }] });
  panels.add({ kind: "page", t: 1, screen: "", title: "one", lines: [] });
  show(1.5);
  assert.deepEqual([cell.state.value?.power, cell.page.value?.title], [false, "one"]);
  assert.deepEqual(cell.motion.value.queue, []);
  show(2);
  assert.deepEqual(cell.motion.value.queue.map(({ program, line }) => [program, line]), [["start", 12]]);
  panels.add({ kind: "state", ...state(2, { power: false }) });
  assert.equal(cell.state.value?.power, false);
});

test("the line of the present move is that of the arm, at rest that of the first recorded move", () => {
  const executed = signal<MovingLine | undefined>(undefined);
  const { model: panels, cell, show } = model(executed);
  assert.equal(cell.moving.value, undefined);
  panels.add({ kind: "motion", t: 1, path: [], queue: [{ id: 1, type: "movej", source: 3, phase: "nominal", target: [], leave: null, reach: null, leaveDistance: null, reachDistance: null }] });
  show(1);
  assert.deepEqual(cell.moving.value, { program: "start", line: 12, file: "/cell/start.pgx", instruction: "movej", isWaiting: true });
  executed.value = { program: "start", line: 13, file: "/cell/start.pgx", instruction: "movel", isWaiting: false };
  assert.equal(cell.moving.value, executed.value);
});

test("points that operators change are unsaved, those that programs change are not", (context) => {
  context.mock.timers.enable({ apis: ["setTimeout"] });
  const { model: panels, cell, show } = model();
  panels.add({ kind: "data", t: 1, points: [{ name: "pA", key: null, local: [5], pose: [5] }] });
  show(1);
  assert.deepEqual([cell.points.value[0]?.local, cell.unsaved.value.size], [[5], 0]);
  panels.addUnsaved({ points: [{ name: "pA", key: null }, { name: "pB", key: "2" }] });
  assert.deepEqual([...cell.unsaved.value], ["pA", "pB[2]"]);
  assert.equal(cell.undo.value, undefined);
  panels.addUnsaved({ points: [], undo: { name: "pA", key: null } });
  assert.deepEqual(cell.undo.value, { name: "pA", key: null });
  assert.equal(cell.unsaved.value.size, 0);
});

test("joint positions follow their changes", (context) => {
  context.mock.timers.enable({ apis: ["setTimeout"] });
  const { model: panels, cell, show } = model();
  panels.addScene({ ...SCENE, joints: [{ name: "jHome", key: null, values: [0, 0] }] });
  panels.add({ kind: "data", t: 1, points: [], joints: [{ name: "jHome", key: null, values: [5, 6] }] });
  assert.deepEqual(cell.joints.value.map(({ values }) => values), [[0, 0]]);
  show(1);
  assert.deepEqual(cell.joints.value.map(({ values }) => values), [[5, 6]]);
});

test("the range of the chart follows the run until it is zoomed", (context) => {
  context.mock.timers.enable({ apis: ["setTimeout"] });
  const { cell } = model();
  assert.deepEqual(cell.range.value, [0, 10]);
  cell.setRange(2, 4);
  assert.deepEqual(cell.range.value, [2, 4]);
  cell.setRange(0, 10);
  assert.deepEqual(cell.range.value, cell.whole.value);
});

test("a new scene forgets everything before it", (context) => {
  context.mock.timers.enable({ apis: ["setTimeout"] });
  const { model: panels, cell } = model();
  panels.add({ kind: "state", ...state(0) });
  panels.add({ kind: "events", events: [{ t: 0, kind: "print", text: "x" }] });
  panels.addScene(SCENE);
  assert.deepEqual([cell.state.value, cell.history.events.length], [undefined, 0]);
});

test("a slow signal shows the last value in the end", (context) => {
  context.mock.timers.enable({ apis: ["setTimeout"] });
  const source = signal(0);
  const slow = throttled(source, 200);
  source.value = 1;
  source.value = 2;
  assert.equal(slow.value, 0);
  context.mock.timers.tick(200);
  assert.equal(slow.value, 2);
  context.mock.timers.tick(500);
  source.value = 3;
  assert.equal(slow.value, 3);
});

test("values out of reach are those of the last move's tool at the shown time, or of the chosen tool", () => {
  const { model: panels, cell, show } = model();
  const far = { name: "pA", key: null, reason: "too far" };
  panels.add({ kind: "reach", t: 0, tool: 1, unreachable: [] });
  panels.add({ kind: "reach", t: 4, tool: 2, unreachable: [far] });
  const shown = (): string => `${cell.unreachable.value.tool ?? "unknown"}: ${[...cell.unreachable.value.reasons.keys()].join()}`;
  show(3);
  assert.equal(shown(), "unknown: ");
  show(5);
  assert.equal(shown(), "tGripper: pA");
  cell.chosenReach.value = { tool: "flange", reasons: new Map() };
  assert.equal(shown(), "flange: ");
  panels.addScene(SCENE);
  assert.equal(shown(), "unknown: ");
});
