import assert from "node:assert/strict";
import { test } from "node:test";
import { Box3, type Mesh, type MeshStandardMaterial } from "three";
import { armFrames } from "../../src/kinematics";
import { frameOf, poseOf } from "../../src/panels/pendant/pose";
import { carrierFrame, type CarrierFrames, CellObjects } from "../../src/scene/CellObjects";
import { LIGHT } from "../../src/scene/palette";
import { objectSolid } from "../../src/scene/solids";
import type { ObjectCarrier, ObjectShape } from "../../src/wire";
import ARMS from "./armCapsules.json";

const HERE = [0, 0, 0, 0, 0, 0];

/** Returns the box around a shape, rounded to 0.001 mm. */
function box(shape: ObjectShape): number[][] {
  const geometry = objectSolid(shape);
  geometry.computeBoundingBox();
  const { min, max } = geometry.boundingBox ?? new Box3();
  return [min, max].map((corner) => corner.toArray().map((value) => Math.round(value * 1000) / 1000 + 0));
}

test("shapes have their sizes and poses", () => {
  assert.deepEqual(box({ kind: "box", size: [100, 40, 20], pose: [1, 2, 3, 0, 0, 90] }), [[-19, -48, -7], [21, 52, 13]]);
  assert.deepEqual(box({ kind: "cylinder", radius: 10, length: 60, pose: [0, 0, 5, 0, 0, 0] }), [[-10, -10, -25], [10, 10, 35]]);
  assert.deepEqual(box({ kind: "cylinder", radius: 10, length: 60, pose: [0, 0, 0, 90, 0, 0] }), [[-10, -30, -10], [10, 30, 10]]);
  assert.deepEqual(box({ kind: "capsule", from: [0, 0, 40], to: [0, 0, 195], radius: 40, pose: HERE }), [[-40, -40, 0], [40, 40, 235]]);
  assert.deepEqual(box({ kind: "capsule", from: [5, 0, 0], to: [5, 0, 0], radius: 40, pose: HERE }), [[-35, -40, -40], [45, 40, 40]]);
  const corners = Buffer.from(new Float32Array([0, 0, 0, 10, 0, 0, 0, 20, 30]).buffer).toString("base64");
  assert.deepEqual(box({ kind: "mesh", corners, pose: [0, 0, 1, 0, 0, 0] }), [[0, 0, 1], [10, 20, 31]]);
});

const [{ arm } = { arm: undefined }] = ARMS;
assert.ok(arm);
const point = { father: null, local: HERE, config: null };
const FRAMES: CarrierFrames = {
  base: frameOf([]), arm: armFrames(arm, frameOf([]), [0, 90, 0, 0, 0, 0]),
  frames: [{ ...point, name: "fPallet", key: "0", pose: [500, 0, 0, 0, 0, 0] }, { ...point, name: "fPallet", key: "1", pose: [600, 0, 0, 0, 0, 0] }, { ...point, name: "lib:fGrid", key: "0,1", pose: [700, 0, 0, 0, 0, 0] }],
  tools: [{ ...point, name: "tGripper", key: null, pose: [0, 0, 100, 0, 0, 0] }],
};

test("things are at the places of their carriers", () => {
  const place = (carrier: ObjectCarrier): number[] | undefined => {
    const frame = carrierFrame(carrier, FRAMES);
    return frame && poseOf(frame).slice(0, 3).map((length) => Math.round(length) + 0);
  };
  assert.deepEqual(place({ kind: "world" }), [0, 0, 0]);
  assert.deepEqual(place({ kind: "flange" }), [920, 20, 0]);
  assert.deepEqual(place({ kind: "tool", name: "tGripper" }), [1020, 20, 0]);
  assert.deepEqual(place({ kind: "link", link: 3 }), [400, 0, 0]);
  assert.deepEqual(["fPallet", "fPallet[1]", "lib:fGrid[0,1]"].map((name) => place({ kind: "frame", name })?.[0]), [500, 600, 700]);
  assert.equal(place({ kind: "frame", name: "fOther" }), undefined);
});

test("a near thing and a touching thing have their own colours, and a thing without a place is hidden", () => {
  const shapes: ObjectShape[] = [{ kind: "box", size: [100, 40, 20], pose: HERE }];
  const objects = new CellObjects([
    { name: "fence", colour: "#ff0000", carrier: { kind: "world" }, shapes }, { name: "rack", colour: null, carrier: { kind: "frame", name: "fPallet" }, shapes },
    { name: "lost", colour: null, carrier: { kind: "frame", name: "fOther" }, shapes },
  ], [], LIGHT);
  const colours = (): string[] => objects.group.children.map((part) => ((part.children[0] as Mesh).material as MeshStandardMaterial).emissive.getHexString());
  objects.place(FRAMES, [], new Map([["fence", "near"], ["rack", "contact"]]));
  assert.deepEqual(colours(), ["f08c00", "d81e1e", "000000"]);
  assert.deepEqual(objects.group.children.map(({ visible }) => visible), [true, true, false]);
  assert.equal(objects.lowest(), -10);
  objects.place(FRAMES, [], new Map());
  assert.deepEqual(colours(), ["000000", "000000", "000000"]);
});

test("a part is where its carrier takes it, and hidden once it was removed", () => {
  const shapes: ObjectShape[] = [{ kind: "box", size: [100, 40, 20], pose: HERE }];
  const objects = new CellObjects([], [{ name: "carton", colour: null, shapes }], LIGHT);
  const [body] = objects.group.children;
  const at = (carrier: ObjectCarrier | null): (number | boolean)[] => {
    objects.place(FRAMES, [{ name: "carton", carrier, pose: [0, 0, 50, 0, 0, 0] }], new Map());
    return [body?.visible ?? false, ...[12, 13, 14].map((index) => Math.round(body?.matrix.elements[index] ?? NaN) + 0)];
  };
  assert.deepEqual(at({ kind: "world" }), [true, 0, 0, 50]);
  assert.deepEqual(at({ kind: "frame", name: "fPallet" }), [true, 500, 0, 50]);
  assert.deepEqual(at({ kind: "flange" }), [true, 970, 20, 0]);
  assert.equal(at(null)[0], false);
  objects.place(FRAMES, [], new Map());
  assert.equal(body?.visible, false, "without a message, its place is unknown");
});
