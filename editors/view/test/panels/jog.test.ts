import assert from "node:assert/strict";
import { test } from "node:test";
import { type ArmChain, flangeAt, jointsNear } from "../../src/panels/pendant/armModel";
import { cartesianStep, fraction, goStep, jointStep, mayContinue, stepsIn } from "../../src/panels/pendant/jogSteps";
import { INCHES, MILLIMETRES } from "../../src/panels/shared/lengths";
import { composed, frameOf, IDENTITY, poseOf } from "../../src/panels/pendant/pose";

const SIX: ArmChain = {
  axes: [180, 130, 145, 270, 120, 270].map((limit) => ({ isLinear: false, min: -limit, max: limit })),
  links: [
    { offset: [0, 0, 478, 0, 0, 0], axis: [0, 0, 1] },
    { offset: [50, 0, 0, 0, 0, 0], axis: [0, 1, 0] },
    { offset: [0, 0, 425, 0, 0, 0], axis: [0, 1, 0] },
    { offset: [0, 50, 0, 0, 0, 0], axis: [0, 0, 1] },
    { offset: [0, 0, 425, 0, 0, 0], axis: [0, 1, 0] },
    { offset: [0, 0, 100, 0, 0, 0], axis: [0, 0, 1] },
  ],
  flange: [0, 0, 0, 0, 0, 0],
};
const SCARA: ArmChain = {
  axes: [{ isLinear: false, min: -140, max: 140 }, { isLinear: false, min: -140, max: 140 }, { isLinear: true, min: 0, max: 200 }, { isLinear: false, min: -500, max: 500 }],
  links: [
    { offset: [0, 0, 300, 0, 0, 0], axis: [0, 0, 1] },
    { offset: [320, 0, 0, 0, 0, 0], axis: [0, 0, 1] },
    { offset: [280, 0, 0, 0, 0, 0], axis: [0, 0, -1] },
    { offset: [0, 0, 0, 0, 0, 0], axis: [0, 0, -1] },
  ],
  flange: [0, 0, 0, 180, 0, 0],
};
const START = [10, 20, 90, 15, 60, -30];
const STRAIGHT = { frame: IDENTITY, base: frameOf([100, 0, 0, 0, 0, 90]), tool: frameOf([0, 0, 120, 0, 0, 45]) };

function near(actual: readonly number[], wanted: readonly number[], tolerance: number): void {
  actual.forEach((value, at) => assert.ok(Math.abs(value - (wanted[at] ?? NaN)) < tolerance, `${actual.join()} instead of ${wanted.join()}`));
}

test("a pose keeps its values", () => {
  for (const pose of [[1, 2, 3, 10, 20, 30], [0, 0, 0, -170, -80, 100], [0, 0, 0, 30, 90, 0], [0, 0, 0, 30, -90, 0]]) {
    near(poseOf(frameOf(pose)), pose, 1e-6);
  }
});

test("an axis moves by a step, at most to its limit", () => {
  assert.deepEqual(jointStep(SIX, START, 2, 5), { joints: [10, 20, 95, 15, 60, -30] });
  assert.deepEqual(jointStep(SIX, START, 4, 100), { joints: [10, 20, 90, 15, 120, -30] });
  assert.deepEqual(jointStep(SIX, [10, 20, 90, 15, 120, -30], 4, 1), { refusal: "Axis 5 is at its limit." });
});

test("the tool centre point moves along and around the axes of world", () => {
  for (const [direction, step] of [[0, 10], [2, -30], [4, 5]] as const) {
    const result = cartesianStep(SIX, START, { ...STRAIGHT, direction, step });
    assert.ok("joints" in result, JSON.stringify(result));
    const tcp = (joints: number[]): number[] => poseOf(composed(STRAIGHT.base, composed(flangeAt(SIX, joints), STRAIGHT.tool)));
    const [before, after] = [tcp(START), tcp(result.joints)];
    const way = [0, 1, 2].map((at) => (after[at] ?? 0) - (before[at] ?? 0));
    near(way, [0, 1, 2].map((at) => (at === direction ? step : 0)), 0.01);
  }
});

test("the tool moves along its own axes", () => {
  const result = cartesianStep(SIX, START, { ...STRAIGHT, frame: undefined, direction: 2, step: 10 });
  assert.ok("joints" in result);
  const before = composed(flangeAt(SIX, START), frameOf([0, 0, 130, 0, 0, 45]));
  near(poseOf(composed(flangeAt(SIX, result.joints), STRAIGHT.tool)), poseOf(before), 0.01);
});

test("an arm with four axes moves in its plane and does not tilt", () => {
  const start = [30, 40, 100, 0];
  const along = cartesianStep(SCARA, start, { frame: IDENTITY, base: IDENTITY, tool: IDENTITY, direction: 1, step: 10 });
  assert.ok("joints" in along);
  near(along.joints.slice(2, 3), [100], 1e-3);
  const tilt = cartesianStep(SCARA, start, { frame: IDENTITY, base: IDENTITY, tool: IDENTITY, direction: 3, step: 5 });
  assert.ok("refusal" in tilt);
});

test("a position outside the limits or the reach is refused", () => {
  assert.ok("refusal" in jointsNear(SIX, START, frameOf([5000, 0, 0, 0, 0, 0]), IDENTITY));
  const low = { ...SIX, axes: SIX.axes.map((axis) => ({ ...axis, min: -1000, max: 60 })) };
  const result = cartesianStep(low, START, { ...STRAIGHT, direction: 0, step: 1 });
  assert.deepEqual(result, { refusal: "Axis 3 would leave its limits." });
});

test("a held button waits for the arm", () => {
  assert.equal(mayContinue([0], [5], [0]), true);
  assert.equal(mayContinue([0], [15], [10]), false);
  assert.equal(mayContinue([8, 1], [15, 1], [10, 1]), true);
});

test("a bar shows where a value is between its limits", () => {
  assert.deepEqual([fraction(-180, -180, 180), fraction(0, -180, 180), fraction(500, -180, 180), fraction(1, 1, 1)], [0, 0.5, 1, 0]);
});

test("a way in joints has steps of 5 degrees and ends at its target", () => {
  const step = goStep([10, -4]);
  assert.deepEqual(step([0, 0]), { joints: [5, -2] });
  assert.deepEqual(step([6, -3]), { joints: [10, -4] });
  assert.deepEqual(step([10, -4]), { refusal: "The arm is there.", isArrival: true });
});

test("lengths of steps are in mm, and their texts in the length unit", () => {
  const [millimetres, inches] = [stepsIn(MILLIMETRES)[2], stepsIn(INCHES)[2]];
  assert.deepEqual(millimetres, { length: 5, angle: 5, text: "5 mm, 5°" });
  assert.deepEqual(inches, { length: 0.2 * 25.4, angle: 5, text: "0.2 in, 5°" });
});
