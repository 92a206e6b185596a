import assert from "node:assert/strict";
import { test } from "node:test";
import { enteredJoints } from "../../src/panels/pendant/enteredJoints";
import { INCHES, MILLIMETRES } from "../../src/panels/shared/lengths";
import { taughtText, teachingCommand } from "../../src/panels/points/taughtPositions";
import { chosenPose, FLANGE } from "../../src/panels/points/tools";

const [A, B, C, D] = [[1], [2], [3], [4]] as const;

test("a frame needs three positions, a tool four", () => {
  const frame = { name: "fTable", key: "1" };
  assert.deepEqual(teachingCommand("frame", frame, undefined, [A, undefined, C]), { missing: "On the x axis" });
  assert.deepEqual(teachingCommand("frame", frame, FLANGE, [A, B, C]), { command: "teachFrame", args: { name: "fTable", key: "1", joints: [A, B, C], tool: FLANGE } });
  const tool = { name: "tA", key: null };
  assert.deepEqual(teachingCommand("tool", tool, FLANGE, [A, B, C, undefined]), { missing: "Position 4" });
  assert.deepEqual(teachingCommand("tool", tool, FLANGE, [A, B, C, D]), { command: "teachTool", args: { ...tool, joints: [A, B, C, D] } });
});

test("a taught tool shows its residual", () => {
  assert.equal(taughtText("tool", { error: null, residual: 0.12345 }, MILLIMETRES), "Computed; the tip is at most 0.123 mm from the touched place.");
  assert.equal(taughtText("frame", { error: null }, MILLIMETRES), "Computed.");
});

test("jogging uses the chosen tool", () => {
  const tools = [{ name: "tA", key: "1", father: null, pose: [1, 2, 3, 0, 0, 0], local: [0, 0, 0, 0, 0, 0] } as const];
  assert.deepEqual(chosenPose({ name: "tA", key: "1" }, [...tools] as never), [1, 2, 3, 0, 0, 0]);
  assert.deepEqual([chosenPose(FLANGE, []), chosenPose(undefined, []), chosenPose({ name: "tB", key: null }, [])], [[], undefined, undefined]);
});

test("entered joints are numbers within the limits", () => {
  const axes = [{ isLinear: false, min: -180, max: 180 }, { isLinear: true, min: 0, max: 200 }];
  assert.deepEqual(enteredJoints(axes, ["-10,5", " 200 "], MILLIMETRES), { joints: [-10.5, 200] });
  assert.deepEqual(enteredJoints(axes, ["0", ""], MILLIMETRES), { refusal: "J2 needs a number, not \"\"." });
  assert.deepEqual(enteredJoints(axes, ["-180.1", "0"], MILLIMETRES), { refusal: "J1 is -180.1, outside the range from -180 to 180 degrees." });
  assert.deepEqual(enteredJoints(axes, ["0", "201"], MILLIMETRES), { refusal: "J2 is 201, outside the range from 0 to 200 mm." });
  assert.deepEqual(enteredJoints(axes, ["25.4", "2"], INCHES), { joints: [25.4, 50.8] });
  assert.deepEqual(enteredJoints(axes, ["0", "8"], INCHES), { refusal: "J2 is 8, outside the range from 0 to 7.874 in." });
});
