import assert from "node:assert/strict";
import { test } from "node:test";
import { ArmGhost, ghostLines } from "../../src/scene/ArmGhost";
import { LIGHT } from "../../src/scene/palette";
import type { Scene } from "../../src/protocol";

const rotation = { isLinear: false, min: -180, max: 180 };
/** Two links of 400 and 300 mm in the plane, with a pedestal of 100 mm. */
const CELL = {
  base: [10, 0, 0, 0, 0, 0],
  arm: { axes: [rotation, rotation], links: [{ offset: [0, 0, 100], axis: [0, 0, 1] }, { offset: [400, 0, 0], axis: [0, 0, 1] }], flange: [300, 0, 0] },
} as unknown as Scene;

const rounded = (numbers: readonly number[]): number[] => numbers.map((value) => Math.round(value) + 0);

test("the ghost stands at its joints, with its tool", () => {
  const { lines, flange, centre } = ghostLines(CELL, [90, -90], [0, 0, 50]);
  assert.deepEqual(lines.map(([, end]) => rounded(end)), [[10, 0, 100], [10, 400, 100], [310, 400, 100]]);
  assert.deepEqual([flange.position, centre.position].map(rounded), [[310, 400, 100], [310, 400, 150]]);
});

test("the ghost is drawn while there is a goal", () => {
  const ghost = new ArmGhost();
  const shown = (): unknown => [ghost.objects.map(({ visible }) => visible), ghost.labels.map(({ text }) => text)];
  ghost.place(CELL, { joints: [0, 0], text: "pPick: righty" }, [], 10, LIGHT);
  assert.deepEqual(shown(), [[true, true], ["Go to pPick: righty"]]);
  ghost.place(CELL, undefined, [], 10, LIGHT);
  assert.deepEqual(shown(), [[false, false], []]);
});
