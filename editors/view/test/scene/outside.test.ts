import assert from "node:assert/strict";
import { test } from "node:test";
import { PerspectiveCamera } from "three";
import { arrow, directionTo, placesTowards } from "../../src/scene/outside";

/** A camera at the origin that looks along x; y is to the left. */
function camera(): PerspectiveCamera {
  const made = new PerspectiveCamera(35, 1.5, 10, 100_000);
  made.up.set(0, 0, 1);
  made.lookAt(1000, 0, 0);
  made.updateMatrixWorld(true);
  return made;
}

test("positions outside the picture have the arrow to them, also behind the camera", () => {
  const shown = [[100, -5000, 0], [100, 5000, 0], [100, 0, 5000], [-5000, 0, -100], [100, -3000, 3000]].map((at) => arrow(directionTo(at, camera())));
  assert.deepEqual(shown, ["→", "←", "↑", "↓", "↗"]);
  assert.equal(arrow(directionTo([5000, 0, 0], camera())), "↓");
});

test("places are within the picture, from the border inwards", () => {
  for (const direction of [[1, 0], [-1, 0], [0, 1], [0.6, -0.8]] as const) {
    const places = placesTowards(direction, [800, 600], [200, 18]);
    for (const [x, y] of places) {
      assert.ok(x >= 0 && y >= 0 && x + 200 <= 800 && y + 18 <= 600, `${x}, ${y}`);
    }
    const [[x, y] = [NaN, NaN]] = places;
    assert.ok(x === 0 || y === 0 || x === 600 || y === 582, "the first place is at the border");
  }
});
