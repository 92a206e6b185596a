import assert from "node:assert/strict";
import { test } from "node:test";
import { areaBetween, type Axes, contains, fitted, WHOLE, type Lens } from "../../src/scene/fitting";

const AXES: Axes = { across: [0, 1, 0], up: [0, 0, 1], back: [1, 0, 0] };
const AREA = { left: -0.9, right: 0.9, bottom: -0.5, top: 0.8 };
const BOX = [0, 1000].flatMap((x) => [-400, 900].flatMap((y) => [-300, 1500].map((z) => [x, y, z] as const)));

/** Returns the shown coordinates of positions, -1 to 1 within the picture. */
function shown({ slope, aspect, isParallel }: Lens): number[][] {
  const { target, distance } = fitted(BOX, AXES, { slope, aspect, isParallel }, AREA);
  return BOX.map(([x, y, z]) => {
    const away = (isParallel ? distance : distance - (x - target[0])) * slope;
    return [(y - target[1]) / (away * aspect), (z - target[2]) / away];
  });
}

for (const isParallel of [true, false]) {
  for (const aspect of [0.6, 1.8]) {
    test(`all positions are within the free area, which they fill (${isParallel ? "parallel" : "perspective"}, ${aspect})`, () => {
      const places = shown({ slope: 0.315, aspect, isParallel });
      const [across, up] = [0, 1].map((axis) => places.map((place) => place[axis] ?? NaN));
      const near = (values: number[] = []): [number, number] => [Math.min(...values), Math.max(...values)];
      const [[left, right], [bottom, top]] = [near(across), near(up)];
      assert.ok(left >= -0.905 && right <= 0.905 && bottom >= -0.505 && top <= 0.805, JSON.stringify([left, right, bottom, top]));
      assert.ok(right - left > 1.79 || top - bottom > 1.29, "one direction is filled");
    });
  }
}

test("a single position is shown from a distance", () => {
  const { target, distance } = fitted([[10, 20, 30]], AXES, { slope: 0.3, aspect: 1, isParallel: false }, { left: -1, right: 1, bottom: -1, top: 1 });
  assert.deepEqual(target, [10, 20, 30]);
  assert.ok(distance >= 200);
});

test("the free area is between the bars at the top and at the bottom", () => {
  const { top, bottom } = areaBetween(400, [{ top: 8, bottom: 40 }, { top: 350, bottom: 392 }, { top: 100, bottom: 380 }]);
  assert.deepEqual([top, bottom], [0.8, -0.75]);
});

test("a bar that grows covers a part of the area before", () => {
  const [low, high] = [areaBetween(400, [{ top: 360, bottom: 392 }]), areaBetween(400, [{ top: 290, bottom: 392 }])];
  assert.deepEqual([contains(low, high), contains(high, low), contains(WHOLE, low), contains(low, low)], [true, false, true, true]);
});
