import assert from "node:assert/strict";
import { test } from "node:test";
import { signal } from "@preact/signals";
import { firstChoice, solutionsOf, solutionText } from "../../src/panels/points/solutions";
import { reasonsOf } from "../../src/panels/points/reachQuery";
import { frameArguments, framesFor, frameText } from "../../src/panels/points/frames";
import { FLANGE, handTool, taughtConfig, toolArguments, toolText } from "../../src/panels/points/tools";
import { shownTools } from "../../src/scene/FrameMarks";
import { MILLIMETRES } from "../../src/panels/shared/lengths";
import { editedTrsf, fatherText, fieldTexts, pointText } from "../../src/panels/points/edits";

test("points have the names that programs write", () => {
  assert.deepEqual([{ name: "pA", key: null }, { name: "pA", key: "2" }, { name: "pA", key: "le\"ft" }].map(pointText), ["pA", "pA[2]", "pA[\"le\\\"ft\"]"]);
});

test("a field that was not edited keeps its exact value", () => {
  const before = [1.23456, -0.00001, 3, 0, 0, 0];
  const texts = fieldTexts(before, MILLIMETRES);
  assert.deepEqual(texts, ["1.235", "0", "3", "0", "0", "0"]);
  assert.deepEqual(editedTrsf([...texts.slice(0, 2), "7,5", ...texts.slice(3)], before, MILLIMETRES), { trsf: [1.23456, -0.00001, 7.5, 0, 0, 0] });
});

test("a field without a number is named", () => {
  assert.deepEqual(editedTrsf(["1", "", "3", "0", "0", "0"], [1, 2, 3, 0, 0, 0], MILLIMETRES), { wrong: "y needs a number, not \"\"." });
  assert.deepEqual(editedTrsf(["1", "2", "3", "0", "0", "x"], [1, 2, 3, 0, 0, 0], MILLIMETRES), { wrong: "rz needs a number, not \"x\"." });
});

test("frames are listed up to world, even in a circle", () => {
  const fathers = new Map<string, string | null>([["fA", "fB"], ["fB", null], ["fX", "fY"], ["fY", "fX"]]);
  assert.equal(fatherText("fA", fathers), "fA in fB in world");
  assert.equal(fatherText(null, fathers), "world");
  assert.equal(fatherText("fX", fathers), "fX in fY in world");
});

test("the configuration of the arm is taught, but fields that stay the same keep their words", () => {
  assert.deepEqual(taughtConfig("righty efree wsame", "lefty epositive wnegative"), ["lefty", "epositive", "wsame"]);
  assert.deepEqual(taughtConfig(null, "lefty"), ["lefty"]);
  assert.deepEqual(taughtConfig("righty", undefined), []);
});

test("the tool is the chosen one or the one of the last move", () => {
  const tool = { name: "tTools", key: "1" };
  assert.deepEqual([toolText(tool, "tA"), toolText(undefined, "tA"), toolText(undefined, null)], ["tTools[1]", "tA", "the last move's tool"]);
  assert.deepEqual([toolArguments(undefined), toolArguments(tool)], [{}, { tool }]);
});

test("the centre point is that of the chosen tool, otherwise of the last move's tool", () => {
  const gripper = { name: "tGripper", key: null, father: null, local: [0, 0, 120], pose: [0, 0, 120], file: "", line: 1 };
  const sample = signal({ joints: [], tool: [0, 0, 7], toolName: "tSuction" });
  const cell = (chosen: typeof FLANGE | undefined): Parameters<typeof handTool>[0] => ({ chosenTool: signal(chosen), tools: signal([gripper]), sample });
  assert.deepEqual(handTool(cell(undefined)), { name: "tSuction", pose: [0, 0, 7], isOfLastMove: true });
  assert.deepEqual(handTool(cell({ name: "tGripper", key: null })), { name: "tGripper", pose: [0, 0, 120], isOfLastMove: false });
  assert.deepEqual(handTool(cell(FLANGE)), { name: "flange", pose: [], isOfLastMove: false });
  assert.equal(handTool(cell({ name: "tOther", key: null })).name, "tSuction");
  assert.deepEqual([...shownTools(cell({ name: "tGripper", key: null }), "tGripper").keys()], ["tSuction", "tGripper"]);
});

test("the arm goes to the joints of movej, or to others in reach", () => {
  const far = { config: "lefty", joints: null, reason: "too far", isChosen: false };
  const near = { config: "righty", joints: [1, -0.04], reason: null, isChosen: false };
  assert.deepEqual(solutionsOf({ error: null, solutions: [far, near, 1] }), [far, near]);
  assert.deepEqual([firstChoice([far, near]), firstChoice([near, { ...near, isChosen: true }]), firstChoice([far])], [1, 1, -1]);
  assert.deepEqual([far, near].map((solution) => solutionText(solution, [], MILLIMETRES)), ["too far", "1.0  0.0"]);
});

test("values out of reach have their reasons by name", () => {
  const unreachable = [{ name: "pA", key: "2", reason: "too far" }, { name: "pB" }];
  assert.deepEqual([...reasonsOf(unreachable)], [["pA[2]", "too far"]]);
  assert.equal(reasonsOf(undefined).size, 0);
});

test("a point is taught in its father, in world, or in a frame of its application", () => {
  const frames = ["fTable", "part:fGrip"].map((name) => ({ name, key: null }));
  const rack = { name: "fRack", key: "left" };
  const texts = (name: string, father: string | null): string[] => framesFor({ name, father }, [...frames, rack]).map((frame) => frameText(frame, null));
  assert.deepEqual(texts("pPick", "fTable"), ["world", 'fRack["left"]']);
  assert.deepEqual(texts("pPick", "fRack[left]"), ["world", "fTable"]);
  assert.deepEqual(texts("part:pPick", null), ["part:fGrip"]);
  assert.deepEqual([frameText(undefined, null), frameText(undefined, "fTable")], ["world", "fTable"]);
  assert.deepEqual([frameArguments(undefined), frameArguments(rack)], [{}, { frame: rack }]);
});
