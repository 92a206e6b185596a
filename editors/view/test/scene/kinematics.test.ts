import assert from "node:assert/strict";
import { test } from "node:test";
import { armFrames, armLength, floorHeight } from "../../src/kinematics";
import { frameOf, poseOf } from "../../src/panels/pendant/pose";
import { flangeAt } from "../../src/panels/pendant/armModel";
import { hasReach, reachOutline } from "../../src/scene/reach";

const SIX = {
  axes: [180, 130, 145, 270, 120, 270].map((limit) => ({ isLinear: false, min: -limit, max: limit })),
  links: [
    { offset: [0, 0, 375, 0, 0, 0], axis: [0, 0, 1] }, { offset: [0, 20, 0, 0, 0, 0], axis: [0, 1, 0] },
    { offset: [0, 0, 290, 0, 0, 0], axis: [0, 1, 0] }, { offset: [0, 0, 0, 0, 0, 0], axis: [0, 0, 1] },
    { offset: [0, 0, 310, 0, 0, 0], axis: [0, 1, 0] }, { offset: [0, 0, 70, 0, 0, 0], axis: [0, 0, 1] },
  ],
  flange: [0, 0, 0, 0, 0, 0],
};

function near(actual: readonly number[], wanted: readonly number[]): void {
  actual.forEach((value, at) => assert.ok(Math.abs(value - (wanted[at] ?? NaN)) < 1e-6, `${actual.join()} instead of ${wanted.join()}`));
}

test("a stretched arm is above its base", () => {
  near(poseOf(armFrames(SIX, frameOf([]), [0, 0, 0, 0, 0, 0]).flange), [0, 20, 1045, 0, 0, 0]);
});

test("the floor is below an arm whose world lies in its second axis", () => {
  assert.equal(floorHeight(SIX), 0);
  const [first, ...links] = SIX.links;
  assert.equal(floorHeight({ ...SIX, links: [{ ...first, axis: [0, 0, 1], offset: [0, 0, 0, 0, 0, 0] }, ...links] }), -0.4 * armLength(SIX));
});

test("joints turn the links around their axes", () => {
  near(armFrames(SIX, frameOf([]), [0, 90, 0, 0, 0, 0]).flange.position, [670, 20, 375]);
  near(armFrames(SIX, frameOf([]), [90, 90, 0, 0, 0, 0]).flange.position, [-20, 670, 375]);
  near(armFrames(SIX, frameOf([100, 0, 0, 0, 0, 0]), [0, 90, -90, 0, 0, 0]).flange.position, [390, 20, 755]);
});

test("a linear axis moves along its direction", () => {
  const lift = { axes: [{ isLinear: true, min: 0, max: 500 }], links: [{ offset: [0, 0, 100, 0, 0, 0], axis: [0, 0, -1] }], flange: [0, 0, 0, 180, 0, 0] };
  near(poseOf(armFrames(lift, frameOf([]), [60]).flange), [0, 0, 40, 180, 0, 0]);
  assert.equal(hasReach(lift), false);
});

test("jogging and drawing agree about the flange", () => {
  const joints = [10, -35, 80, 20, 40, -100];
  near(poseOf(armFrames(SIX, frameOf([]), joints).flange), poseOf(flangeAt(SIX, joints)));
});

test("the reach ends at the stretched arm", () => {
  assert.equal(armLength(SIX), 690);
  const outline = reachOutline(SIX, []);
  const farthest = Math.max(...outline.map(([distance, height]) => Math.hypot(distance, height - 375)));
  assert.ok(Math.abs(farthest - Math.hypot(670, 20)) < 1, String(farthest));
  assert.ok(outline.every(([distance]) => distance >= 0));
});
