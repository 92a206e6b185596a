import assert from "node:assert/strict";
import { test } from "node:test";
import { isWithin } from "../../src/panels/pendant/pressedArea";

const AREA = { left: 100, right: 180, top: 50, bottom: 76 };

test("a pointer on the pressed button and close to it holds it", () => {
  assert.deepEqual([[140, 60], [100, 76], [93, 45], [188, 84]].map(([x = 0, y = 0]) => isWithin(AREA, x, y)), [true, true, true, true]);
});

test("a pointer that slides off the pressed button releases it", () => {
  assert.deepEqual([[140, 85], [140, 41], [91, 60], [189, 60]].map(([x = 0, y = 0]) => isWithin(AREA, x, y)), [false, false, false, false]);
});
