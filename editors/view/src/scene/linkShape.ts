// Shape of a link from a file: STL in mm with z up, glTF in m with y up.

import { DoubleSide, Group, Mesh, MeshStandardMaterial, type Object3D } from "three";
import { GLTFLoader } from "three/addons/loaders/GLTFLoader.js";
import { STLLoader } from "three/addons/loaders/STLLoader.js";
import type { LinkShape } from "../protocol";

const METRE = 1000;

/** Reads a shape in the frame of its link, in mm with z up. STL files contain no colours. */
export async function readShape({ format, data }: LinkShape, colour: number): Promise<Object3D> {
  const bytes = Uint8Array.from(atob(data), (character) => character.charCodeAt(0)).buffer;
  const shape = format === "stl" ? stl(bytes, colour) : await glb(bytes);
  shape.traverse((part) => {
    part.castShadow = true;
    part.receiveShadow = true;
  });
  return shape;
}

function stl(bytes: ArrayBuffer, colour: number): Object3D {
  const geometry = new STLLoader().parse(bytes);
  if (geometry.getAttribute("position").count === 0) {
    throw new Error("it has no triangles");
  }
  return new Mesh(geometry, new MeshStandardMaterial({ color: colour, roughness: 0.48, metalness: 0.08, side: DoubleSide }));
}

async function glb(bytes: ArrayBuffer): Promise<Object3D> {
  const { scene } = await new GLTFLoader().parseAsync(bytes, "");
  const group = new Group();
  group.add(scene);
  group.rotation.x = Math.PI / 2;
  group.scale.setScalar(METRE);
  return group;
}
