import assert from "node:assert/strict";
import test from "node:test";
import { PerspectiveCamera } from "three";
import { spheresOf } from "../../src/scene/MotionMarks";
import { surfaceAt } from "../../src/scene/picking";

const TARGET = [600, 100, 300, 180, 0, 0];

void test("a queued move has spheres of its leave and reach distances", () => {
  const corner = { target: TARGET, leave: null, reach: null };
  assert.deepEqual(spheresOf([{ ...corner, leaveDistance: 20, reachDistance: 30 }, { ...corner, leaveDistance: 0, reachDistance: null }]), [
    { at: TARGET, radius: 20, kind: "leave" },
    { at: TARGET, radius: 30, kind: "reach" },
  ]);
});

void test("without a solid thing the floor is measured", () => {
  const camera = new PerspectiveCamera(40, 1, 10, 10_000);
  camera.up.set(0, 1, 0);
  camera.position.set(100, 50, 1000);
  camera.lookAt(100, 50, 0);
  camera.updateMatrixWorld();
  const found = surfaceAt(0, 200, 200, [400, 400], camera, []);
  assert.deepEqual(found?.map((value) => Math.round(value) + 0), [100, 50, 0]);
  camera.lookAt(100, 50, 2000);
  camera.updateMatrixWorld();
  assert.equal(surfaceAt(0, 200, 200, [400, 400], camera, []), undefined);
});
