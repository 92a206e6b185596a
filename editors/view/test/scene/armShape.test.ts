// The arm in the picture has the capsules that the controller compares: `armCapsules.json` is written by a test of val3-view.
import assert from "node:assert/strict";
import { test } from "node:test";
import { type BufferGeometry, Mesh, type Object3D, Vector3 } from "three";
import { armFrames, floorHeight } from "../../src/kinematics";
import { frameOf, IDENTITY } from "../../src/panels/pendant/pose";
import { armLines } from "../../src/scene/armLines";
import { ArmShape } from "../../src/scene/armShape";
import { LIGHT } from "../../src/scene/palette";
import ARMS from "./armCapsules.json";

/** Tolerance for positions in 32 bits, in mm. */
const NEAR = 0.01;

type Shape = typeof ARMS[number]["arm"];

function drawn(arm: Shape, joints: readonly number[], base: readonly number[] = []): ArmShape {
  const shape = new ArmShape(arm, base, LIGHT, () => undefined);
  shape.place(armFrames(arm, frameOf(base), joints));
  shape.group.updateMatrixWorld();
  return shape;
}

/** Returns the corners of all triangles of a part in world. */
function corners(part: Object3D | undefined): Vector3[] {
  const found: Vector3[] = [];
  part?.traverse((mesh) => {
    if (mesh instanceof Mesh) {
      const positions = (mesh.geometry as BufferGeometry).getAttribute("position");
      for (let index = 0; index < positions.count; index += 1) {
        found.push(new Vector3().fromBufferAttribute(positions, index).applyMatrix4(mesh.matrixWorld));
      }
    }
  });
  return found;
}

function vector([x = NaN, y = NaN, z = NaN]: readonly number[] = []): Vector3 {
  return new Vector3(x, y, z);
}

/** Returns the distance of a position from the line between two positions. */
function distance(position: Vector3, from: Vector3, to: Vector3): number {
  const way = to.clone().sub(from);
  const share = Math.min(Math.max(position.clone().sub(from).dot(way) / Math.max(way.lengthSq(), 1e-12), 0), 1);
  return position.distanceTo(from.clone().addScaledVector(way, share));
}

for (const { arm, postures } of ARMS) {
  for (const { joints, ends } of postures) {
    test(`the parts of a ${arm.name} at ${joints.join(", ")} are the capsules of the controller`, () => {
      const { children } = drawn(arm, joints).group;
      assert.equal(ends.length, arm.links.length + 1);
      ends.forEach((lines, part) => {
        const surface = corners(children[part]);
        const capsules = lines.map(([from, to], index) => ({ from: vector(from), to: vector(to), radius: arm.capsules[part]?.[index]?.radius ?? NaN }));
        for (const corner of surface) {
          const gap = Math.min(...capsules.map(({ from, to, radius }) => Math.abs(distance(corner, from, to) - radius)));
          assert.ok(gap < NEAR, `part ${part}: a corner is ${gap} mm from the surface`);
        }
        for (const { from, to, radius } of capsules) {
          const way = to.clone().sub(from).normalize().multiplyScalar(radius);
          for (const tip of [from.clone().sub(way), to.clone().add(way)]) {
            const gap = Math.min(...surface.map((corner) => corner.distanceTo(tip)));
            assert.ok(gap < (way.length() > 0 ? NEAR : radius + NEAR), `part ${part}: a tip is ${gap} mm from the surface`);
          }
        }
      });
      assert.deepEqual(armLines(arm, IDENTITY, armFrames(arm, IDENTITY, joints)).map(rounded), ends.flat().map(rounded));
    });
  }
}

function rounded(line: readonly (readonly number[])[]): number[][] {
  return line.map((end) => end.map((value) => Math.round(value * 1000) / 1000 + 0));
}

test("the parts stand on the base of the arm", () => {
  for (const { arm } of ARMS) {
    const [here = [], there = []] = [[], [100, 20, 3]].map((base) => corners(drawn(arm, arm.axes.map(() => 0), base).group));
    assert.ok(here.length > 0 && here.length === there.length);
    here.forEach((corner, index) => assert.ok(there[index] && there[index].distanceTo(corner.add(new Vector3(100, 20, 3))) < NEAR));
  }
});

test("an arm without capsules is drawn along its chain, with a disc at the flange", () => {
  for (const { arm } of ARMS) {
    const { group } = drawn({ ...arm, capsules: [] }, arm.axes.map(() => 0));
    assert.ok(group.children.every((part) => corners(part).length > 0), arm.name);
  }
});

test("the floor is the mounting face, or below the base if its height is unknown", () => {
  assert.deepEqual(ARMS.map(({ arm }) => [arm.name, floorHeight(arm)]), [["TX2-60L", -375], ["TS2-60", -240]]);
});
