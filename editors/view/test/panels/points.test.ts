import assert from "node:assert/strict";
import { test } from "node:test";
import { editedTrsf, fatherText, fieldTexts, pointText } from "../../src/panels/points/edits";

test("points have the names that programs write", () => {
  assert.deepEqual([{ name: "pA", key: null }, { name: "pA", key: "2" }, { name: "pA", key: "le\"ft" }].map(pointText), ["pA", "pA[2]", "pA[\"le\\\"ft\"]"]);
});

test("a field that was not edited keeps its exact value", () => {
  const before = [1.23456, -0.00001, 3, 0, 0, 0];
  const texts = fieldTexts(before);
  assert.deepEqual(texts, ["1.235", "0", "3", "0", "0", "0"]);
  assert.deepEqual(editedTrsf([...texts.slice(0, 2), "7,5", ...texts.slice(3)], before), { trsf: [1.23456, -0.00001, 7.5, 0, 0, 0] });
});

test("a field without a number is named", () => {
  assert.deepEqual(editedTrsf(["1", "", "3", "0", "0", "0"], [1, 2, 3, 0, 0, 0]), { wrong: "y needs a number, not \"\"." });
  assert.deepEqual(editedTrsf(["1", "2", "3", "0", "0", "x"], [1, 2, 3, 0, 0, 0]), { wrong: "rz needs a number, not \"x\"." });
});

test("frames are listed up to world, even in a circle", () => {
  const fathers = new Map<string, string | null>([["fA", "fB"], ["fB", null], ["fX", "fY"], ["fY", "fX"]]);
  assert.equal(fatherText("fA", fathers), "fA in fB in world");
  assert.equal(fatherText(null, fathers), "world");
  assert.equal(fatherText("fX", fathers), "fX in fY in world");
});
