import assert from "node:assert/strict";
import { test } from "node:test";
import { Vector3 } from "three";
import { armFrames, type Chain } from "../../src/kinematics";
import { composed, frameOf, IDENTITY } from "../../src/panels/pendant/pose";
import { Samples } from "../../src/samples";
import { NEAR_OLD, Trail } from "../../src/scene/trail";
import { ToolPositions } from "../../src/toolPositions";
import { scene } from "../sample.mjs";
import { encoded } from "../sampleBatch.mjs";

/** An arm with two linear axes, x and y. */
const ARM = {
  axes: [{ isLinear: true, min: 0, max: 1000 }, { isLinear: true, min: 0, max: 1000 }],
  links: [{ offset: [0, 0, 0, 0, 90, 0], axis: [0, 0, 1] }, { offset: [0, 0, 0, -90, 0, 0], axis: [0, 0, 1] }],
  flange: [0, 0, 0, 0, 0, 0],
};

/** Samples of a second. */
const BATCH = 250;

/** Returns samples at intervals of 4 ms with joints and a phase. */
function samples(list: readonly (readonly [number, number, number])[]): Samples {
  const made = new Samples();
  for (let begin = 0; begin < list.length; begin += BATCH) {
    made.add(encoded(list.slice(begin, begin + BATCH).map(([first, second, phase], index) => ({ t: (begin + index) * 0.004, joints: [first, second], phase }))));
  }
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

/** Checks that pieces follow each other without gaps. */
function assertContinuous(made: Trail): void {
  for (let index = 1; index < made.segments.count; index += 1) {
    assert.equal(made.piece(index)?.from, made.piece(index - 1)?.t);
    assert.deepEqual([...made.segments.at(index)[0]], [...made.segments.at(index - 1)[1]]);
  }
}

void test("every sample of a long path is near the piece of its time", () => {
  const count = 200_000;
  const list = Array.from({ length: count }, (_, index): [number, number, number] => [200 + 40 * Math.sin(index / 10) + index / 1000, 200 + 60 * Math.cos(index / 14), Math.floor(index / 500) % 2]);
  const made = trail(list);
  assert.ok(made.segments.count <= 60_000 && made.segments.count > 30_000, `${made.segments.count}`);
  assert.ok(Number(made.piece(100)?.t) - Number(made.piece(0)?.from) > 1, "old pieces are simplified");
  assertContinuous(made);
  const begin = Number(made.piece(0)?.from);
  for (let index = 0, at = 0; index < count; index += 1) {
    const t = index * 0.004;
    while (at < made.segments.count - 1 && Number(made.piece(at)?.t) < t - 1e-9) {
      at += 1;
    }
    const [from, to] = made.segments.at(at);
    const { position } = armFrames(ARM, IDENTITY, (list[index] ?? []).slice(0, 2)).flange;
    const off = t < begin - 1e-9 ? 0 : distance([...from], [...to], position);
    assert.ok(off <= Number(made.piece(at)?.off) + 1e-3 && Number(made.piece(at)?.off) <= NEAR_OLD, `${off} mm at ${t} s`);
  }
});

void test("pieces of different lines and phases stay apart", () => {
  const made = trail(Array.from({ length: 150_000 }, (_, index): [number, number, number] => [index / 1000, 0, Math.floor(index / 2) % 2]));
  for (let index = 1; index < made.segments.count; index += 1) {
    assert.notEqual(made.piece(index)?.phase, made.piece(index - 1)?.phase);
  }
});

void test("a long path that cannot be simplified loses its oldest pieces", () => {
  const count = 70_000;
  const made = trail(Array.from({ length: count }, (_, index): [number, number, number] => [index / 10, index % 2 === 0 ? 0 : 5, 0]));
  assert.ok(made.segments.count <= 60_000 && made.segments.count >= 45_000, `${made.segments.count}`);
  assertContinuous(made);
  assert.ok(Number(made.piece(0)?.from) > 0);
  assert.equal(made.piece(made.segments.count - 1)?.from, (count - 2) * 0.004);
});

void test("the positions of a path contain its start and its end", () => {
  const positions = [...trail([[0, 0, 0], [500, 0, 0], [500, 300, 1]]).positions()];
  for (const joints of [[0, 0], [500, 300]]) {
    const { position } = armFrames(ARM, IDENTITY, joints).flange;
    assert.ok(positions.some((found) => Math.hypot(...found.map((value, axis) => value - (position[axis] ?? 0))) < 0.001), joints.join());
  }
});

void test("positions without poses of the links are those of the poses", () => {
  const cell = scene() as { arm: Chain };
  const base = frameOf([10, 20, 30, 5, 10, 15]);
  const joints = [12, -34, 56, 78, -90, 123];
  const columns = joints.map((joint) => [0, joint]);
  const expected = composed(armFrames(cell.arm, base, joints).flange, frameOf([1, 2, 120, 40, 50, 60])).position;
  const position = new ToolPositions(cell.arm, base).at(columns, 1, [1, 2, 120, 40, 50, 60]);
  assert.ok(Math.hypot(...position.map((value, axis) => value - (expected[axis] ?? 0))) < 1e-9, position.join());
});

void test("a path is drawn again when its end was replaced by as many samples", () => {
  const made = new Trail();
  const list = samples([[0, 0, 0], [10, 0, 0], [20, 0, 0]]);
  made.follow(list, ARM, IDENTITY, ["nominal"], () => []);
  list.cut(0.005);
  list.add(encoded([{ t: 0.008, joints: [10, 90], phase: 0 }]));
  made.follow(list, ARM, IDENTITY, ["nominal"], () => []);
  const [, end] = made.segments.at(made.segments.count - 1);
  const { position } = armFrames(ARM, IDENTITY, [10, 90]).flange;
  assert.ok(position.every((value, axis) => Math.abs(value - (end[axis] ?? 0)) < 0.001), `${[...end].join()} instead of ${position.join()}`);
});
