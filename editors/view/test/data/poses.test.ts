import assert from "node:assert/strict";
import { test } from "node:test";
import { poseTitle, reachText, worldText } from "../../src/data/poses";
import type { DataPose } from "../../src/data/protocol";

const POSE: DataPose = { name: "pA", key: "0", world: [1, -0.04, 3.25, 0, 0, 90], chain: "pA on fA", reach: "reachable", why: "TX2-90 with `tA`", joints: [0, 1.234, 90] };

test("a pose has a text for its cell and the details in its title", () => {
  assert.equal(worldText(POSE), "1.0  0.0  3.3  0.0  0.0  90.0");
  assert.equal(poseTitle(POSE), "TX2-90 with `tA`\npA on fA\nJoints 0, 1.23, 90");
  assert.equal(worldText({ ...POSE, world: null }), "");
});

test("the cell of the reach is empty only if the reach is unknown although the arm is named", () => {
  const texts = (["reachable", "outOfReach", "noArm", null] as const).map((reach) => reachText({ ...POSE, reach }));
  assert.deepEqual(texts, ["reachable", "out of reach", "no arm", ""]);
});
