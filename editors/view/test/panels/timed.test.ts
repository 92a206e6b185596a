import assert from "node:assert/strict";
import { test } from "node:test";
import type { CellPoint } from "../../src/panels/shared/cell";
import { DataValues } from "../../src/panels/points/pointsAt";
import { latest, TimedLevels } from "../../src/panels/shared/timed";

test("the last entry up to a time is shown", () => {
  const entries = [{ t: 1 }, { t: 2 }];
  assert.deepEqual([0, 1, 1.5, 9].map((t) => latest(entries, t)?.t), [undefined, 1, 1, 2]);
});

test("signals have the states of the shown time", () => {
  const levels = new TimedLevels<{ value: number }>();
  levels.add(0, "a", { value: 0 });
  levels.add(0, "b", { value: 5 });
  levels.add(2, "a", { value: 1 });
  const values = (t: number): [string, number][] => [...levels.at(t)].map(([link, { value }]) => [link, value]);
  assert.deepEqual([values(1), values(2), values(-1)], [[["a", 0], ["b", 5]], [["a", 1], ["b", 5]], []]);
});

test("points have the values of the shown time", () => {
  const points = new DataValues<CellPoint>((message) => message.points);
  points.restart([{ name: "pA", key: null, father: null, local: [1], pose: [1] }, { name: "pB", key: "0", father: "f", local: [2], pose: [2] }]);
  points.add({ t: 3, points: [{ name: "pB", key: "0", local: [7], pose: [8] }] });
  assert.deepEqual(points.at(2).map(({ local }) => local), [[1], [2]]);
  assert.deepEqual(points.at(3).map(({ local, pose, father }) => [local, pose, father]), [[[1], [1], null], [[7], [8], "f"]]);
  assert.equal(points.at(4), points.at(5));
  assert.deepEqual(points.at(0).map(({ local }) => local), [[1], [2]]);
});
