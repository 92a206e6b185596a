import assert from "node:assert/strict";
import { test } from "node:test";
import { Box3, type Object3D } from "three";
import { readShape } from "../../src/scene/linkShape";

function size(shape: Object3D): number[] {
  const { min, max } = new Box3().setFromObject(shape, true);
  return [...min.toArray(), ...max.toArray()].map((value) => Math.round(value * 1000) / 1000);
}

/** A triangle. */
const STL = "solid link\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 10 0 0\nvertex 0 20 30\nendloop\nendfacet\nendsolid link\n";

/** Returns a glTF file with a triangle. */
function glb(corners: readonly number[]): string {
  const positions = Buffer.from(new Float32Array(corners).buffer);
  const json = JSON.stringify({
    asset: { version: "2.0" }, scene: 0, scenes: [{ nodes: [0] }], nodes: [{ mesh: 0 }],
    meshes: [{ primitives: [{ attributes: { POSITION: 0 } }] }],
    accessors: [{ bufferView: 0, componentType: 5126, count: 3, type: "VEC3", min: [0, 0, 0], max: [1, 1, 1] }],
    bufferViews: [{ buffer: 0, byteLength: positions.length }], buffers: [{ byteLength: positions.length }],
  });
  const text = Buffer.from(json.padEnd(Math.ceil(json.length / 4) * 4));
  const head = (length: number, type: number): Buffer => Buffer.from(new Uint32Array([length, type]).buffer);
  const chunks = Buffer.concat([head(text.length, 0x4e4f534a), text, head(positions.length, 0x004e4942), positions]);
  return Buffer.concat([Buffer.from(new Uint32Array([0x46546c67, 2, 12 + chunks.length]).buffer), chunks]).toString("base64");
}

void test("an STL file is in mm with z up", async () => {
  assert.deepEqual(size(await readShape({ format: "stl", data: btoa(STL) }, 0xffffff)), [0, 0, 0, 10, 20, 30]);
});

void test("a GLB file is in m with y up", async () => {
  const shape = await readShape({ format: "glb", data: glb([0, 0, 0, 0.1, 0, 0, 0, 0.2, 0.3]) }, 0xffffff);
  assert.deepEqual(size(shape), [0, -300, 0, 100, 0, 200]);
});

void test("a file has a unit and a pose in the frame of its link", async () => {
  const inMetres = await readShape({ format: "stl", data: btoa(STL), unit: 1000, pose: [1, 2, 3, 0, 0, 90] }, 0xffffff);
  assert.deepEqual(size(inMetres), [-19999, 2, 3, 1, 10002, 30003]);
  const shape = await readShape({ format: "glb", data: glb([0, 0, 0, 100, 0, 0, 0, 200, 300]), unit: 1, pose: [0, 0, -5, 0, 0, 0] }, 0xffffff);
  assert.deepEqual(size(shape), [0, -300, -5, 100, 0, 195]);
});

void test("files that are no shapes are refused", async () => {
  for (const [format, text] of [["stl", ""], ["stl", "solid"], ["stl", "solid\nendsolid\n"], ["glb", ""], ["glb", "glTF"], ["glb", "{}"]] as const) {
    await assert.rejects(readShape({ format, data: btoa(text) }, 0xffffff), `${format} ${text}`);
  }
});
