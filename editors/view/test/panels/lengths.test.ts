import assert from "node:assert/strict";
import { test } from "node:test";
import { coordinateTitle, editedTrsf, fieldTexts } from "../../src/panels/points/edits";
import { solutionText } from "../../src/panels/points/solutions";
import { INCHES, jointTexts, lengthText, MILLIMETRES, poseTexts, unitOf } from "../../src/panels/shared/lengths";

test("lengths in mm have the unit of the application, with the same accuracy", () => {
  assert.deepEqual([unitOf(undefined), unitOf({}), unitOf({ lengthUnit: "mm" }), unitOf({ lengthUnit: "inch" })], [MILLIMETRES, MILLIMETRES, MILLIMETRES, INCHES]);
  assert.deepEqual([MILLIMETRES, INCHES].map((unit) => lengthText(508, 1, unit)), ["508.0 mm", "20.00 in"]);
  assert.deepEqual(poseTexts([25.4, -0.0001, 254, 90, 0, -45], 1, INCHES), ["1.00", "0.00", "10.00", "90.0", "0.0", "-45.0"]);
});

test("only linear axes have a length", () => {
  const axes = [{ isLinear: false }, { isLinear: true }];
  assert.deepEqual([MILLIMETRES, INCHES].map((unit) => jointTexts([10, 50.8], axes, 1, unit)), [["10.0", "50.8"], ["10.0", "2.00"]]);
  assert.equal(solutionText({ config: null, joints: [10, 50.8], reason: null, isChosen: true }, axes, INCHES), "10.0  2.00");
});

test("fields have the values of the data, which are in the unit of the application", () => {
  const before = [1.23456, 2, 3, 45.6789, 0, 0];
  assert.deepEqual(fieldTexts(before, INCHES), ["1.2346", "2", "3", "45.679", "0", "0"]);
  assert.deepEqual(editedTrsf(fieldTexts(before, INCHES).with(1, "2,5"), before, INCHES), { trsf: [1.23456, 2.5, 3, 45.6789, 0, 0] });
  assert.deepEqual([0, 3].map((index) => coordinateTitle(index, INCHES)), ["x (in)", "rx"]);
  assert.equal(coordinateTitle(0, MILLIMETRES), "x");
});
