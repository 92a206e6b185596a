import assert from "node:assert/strict";
import { test } from "node:test";
import { signal } from "@preact/signals";
import type { Range } from "../../src/panels/tasks/range";
import { containing, TimeZoom } from "../../src/timeline/zoom";

test("the range follows the shown time", () => {
  assert.deepEqual(containing([10, 20], 15, [0, 100]), [10, 20]);
  assert.deepEqual(containing([10, 20], 30, [0, 100]), [21, 31]);
  assert.deepEqual(containing([10, 20], 100, [0, 100]), [90, 100]);
  assert.deepEqual(containing([10, 20], 5, [0, 100]), [5, 15]);
});

test("zooming out to the entire time ends the zoom", () => {
  const [whole, time] = [signal<Range>([0, 100]), signal(50)];
  const zoom = new TimeZoom(whole, time);
  zoom.zoom(0.5, 50);
  assert.deepEqual(zoom.range.value, [25, 75]);
  whole.value = [0, 200];
  assert.deepEqual(zoom.range.value, [25, 75]);
  zoom.zoom(8, 50);
  assert.equal(zoom.isZoomed.value, false);
  assert.deepEqual(zoom.range.value, [0, 200]);
});
