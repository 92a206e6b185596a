// Shape of a link from a file: STL with z up, glTF with y up.

import { DoubleSide, Group, Mesh, MeshStandardMaterial, type Object3D } from "three";
import { GLTFLoader } from "three/addons/loaders/GLTFLoader.js";
import { STLLoader } from "three/addons/loaders/STLLoader.js";
import { frameOf } from "../panels/pendant/pose";
import type { LinkShape } from "../protocol";
import { matrixOf } from "./three";

/** Units of the formats in mm, for runs of earlier versions. */
const UNITS = { stl: 1, glb: 1000 };

/** Runs of earlier versions have neither a unit nor a pose. */
type FileShape = Omit<LinkShape, "unit" | "pose"> & Partial<LinkShape>;

/** Reads a shape in the link's frame, in mm with z up. STL files contain no colours. */
export async function readShape({ format, data, unit = UNITS[format], pose = [] }: FileShape, colour: number): Promise<Object3D> {
  const bytes = Uint8Array.from(atob(data), (character) => character.charCodeAt(0)).buffer;
  const content = format === "stl" ? stl(bytes, colour) : await glb(bytes);
  content.scale.setScalar(unit);
  const shape = new Group();
  shape.add(content);
  shape.applyMatrix4(matrixOf(frameOf(pose)));
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
  return group;
}
