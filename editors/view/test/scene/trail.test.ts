import assert from "node:assert/strict";
import { test } from "node:test";
import { Vector3 } from "three";
import { armFrames } from "../../src/kinematics";
import { IDENTITY } from "../../src/panels/pendant/pose";
import { Samples } from "../../src/samples";
import { Trail } from "../../src/scene/trail";

/** An arm with two linear axes, x and y. */
const ARM = {
  axes: [{ isLinear: true, min: 0, max: 1000 }, { isLinear: true, min: 0, max: 1000 }],
  links: [{ offset: [0, 0, 0, 0, 90, 0], axis: [0, 0, 1] }, { offset: [0, 0, 0, -90, 0, 0], axis: [0, 0, 1] }],
  flange: [0, 0, 0, 0, 0, 0],
};

/** Returns samples at intervals of 4 ms with joints and a phase. */
function samples(list: readonly (readonly [number, number, number])[]): Samples {
  const size = 8 + 16 + 8 + 4 + 4 + 1;
  const view = new DataView(new ArrayBuffer(8 + list.length * size));
  view.setUint8(0, 1);
  view.setUint8(1, 2);
  view.setUint32(4, list.length, true);
  list.forEach(([first, second, phase], index) => {
    const at = 8 + index * size;
    view.setFloat64(at, index * 0.004, true);
    view.setFloat64(at + 8, first, true);
    view.setFloat64(at + 16, second, true);
    view.setUint8(at + 36, phase);
  });
  const made = new Samples();
  made.add(view.buffer);
  return made;
}

function trail(list: readonly (readonly [number, number, number])[]): Trail {
  const made = new Trail();
  made.follow(samples(list), ARM, IDENTITY, ["nominal", "blend"], () => []);
  return made;
}

void test("a straight way of one phase is one piece", () => {
  const made = trail(Array.from({ length: 40 }, (_, index) => [index, 0, index < 20 ? 0 : 1]));
  assert.equal(made.segments.count, 2);
  assert.deepEqual([made.piece(0)?.from, made.piece(0)?.phase, made.piece(1)?.phase], [0, 0, 1]);
});

void test("every sample is near the pieces", () => {
  const list = Array.from({ length: 200 }, (_, index): [number, number, number] => [100 * Math.sin(index / 100), 100 * Math.cos(index / 100), 0]);
  const made = trail(list);
  assert.ok(made.segments.count < 60, `${made.segments.count}`);
  for (let index = 1; index < made.segments.count; index += 1) {
    assert.deepEqual([...made.segments.at(index)[0]], [...made.segments.at(index - 1)[1]]);
  }
  const pieces = Array.from({ length: made.segments.count }, (_, index) => made.segments.at(index));
  for (const joints of list) {
    const { position } = armFrames(ARM, IDENTITY, joints.slice(0, 2)).flange;
    const nearest = Math.min(...pieces.map(([from, to]) => distance([...from], [...to], position)));
    assert.ok(nearest < 0.21, `${nearest}`);
  }
});

/** Returns the distance of a position from a segment. */
function distance(from: readonly number[], to: readonly number[], position: readonly number[]): number {
  const [way, off] = [to, position].map((end) => new Vector3(...end).sub(new Vector3(...from))) as [Vector3, Vector3];
  const share = Math.min(Math.max(off.dot(way) / Math.max(way.lengthSq(), 1e-12), 0), 1);
  return off.distanceTo(way.multiplyScalar(share));
}

void test("the path is shown up to the middle of a piece", () => {
  const made = trail(Array.from({ length: 11 }, (_, index) => [index, 0, 0]));
  made.showUpTo(0.02);
  assert.equal(made.shown, 0);
  made.showUpTo(0.04);
  assert.equal(made.shown, 1);
});
