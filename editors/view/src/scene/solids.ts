// Geometries of solids.

import { BoxGeometry, BufferAttribute, BufferGeometry, CylinderGeometry, Matrix4, Quaternion, SphereGeometry, Vector3 } from "three";
import { mergeGeometries } from "three/addons/utils/BufferGeometryUtils.js";
import { frameOf } from "../panels/pendant/pose";
import type { ObjectShape } from "../wire";
import { coloured, matrixOf } from "./three";

/** The points within `radius` of a line, in mm. */
export interface Capsule {
  from: readonly number[];
  to: readonly number[];
  radius: number;
}

/** Number of corners for a circle, and for the quarter circle from a sphere's equator to its pole. */
const [AROUND, QUARTER] = [40, 12];

/** Half width of the band around a capsule: fraction of the line, limited to a fraction of the radius. */
const [LINE_SHARE, RADIUS_SHARE] = [0.15, 0.12];

/**
 * Returns the parts of a cylinder with rounded ends around a line, with a band in its middle. A line without length has a
 * sphere without a band.
 */
export function capsule({ from, to, radius }: Capsule, colour: number, band = colour): BufferGeometry[] {
  const start = vector(from);
  const way = vector(to).sub(start);
  const length = way.length();
  // The parts are built along y from the origin.
  const rounded = (at: number, angle: number): BufferGeometry =>
    coloured(new SphereGeometry(radius, AROUND, QUARTER, 0, Math.PI * 2, angle, Math.PI / 2).translate(0, at, 0), colour);
  const ring = (low: number, high: number, shade: number): BufferGeometry =>
    coloured(new CylinderGeometry(radius, radius, high - low, AROUND, 1, true).translate(0, (low + high) / 2, 0), shade);
  const parts = [rounded(0, Math.PI / 2), rounded(length, 0)];
  if (length > 0) {
    const half = Math.min(length * LINE_SHARE, radius * RADIUS_SHARE);
    parts.push(ring(0, length / 2 - half, colour), ring(length / 2 - half, length / 2 + half, band), ring(length / 2 + half, length, colour));
  }
  const turn = new Quaternion().setFromUnitVectors(new Vector3(0, 1, 0), length > 0 ? way.normalize() : new Vector3(0, 1, 0));
  const pose = new Matrix4().compose(start, turn, new Vector3(1, 1, 1));
  return parts.map((part) => part.applyMatrix4(pose));
}

/** Returns a thing's shape in the carrier's frame. */
export function objectSolid(shape: ObjectShape): BufferGeometry {
  return solidOf(shape).applyMatrix4(matrixOf(frameOf(shape.pose)));
}

function solidOf(shape: ObjectShape): BufferGeometry {
  switch (shape.kind) {
    case "box": {
      const [x = 0, y = 0, z = 0] = shape.size;
      return new BoxGeometry(x, y, z);
    }
    case "cylinder": return new CylinderGeometry(shape.radius, shape.radius, shape.length, AROUND).rotateX(Math.PI / 2);
    case "capsule": return mergeGeometries(capsule(shape, 0));
    case "mesh": return triangles(shape.corners);
  }
}

/** Returns triangles from corner coordinates. */
function triangles(corners: string): BufferGeometry {
  const bytes = Uint8Array.from(atob(corners), (character) => character.charCodeAt(0));
  const geometry = new BufferGeometry();
  geometry.setAttribute("position", new BufferAttribute(new Float32Array(bytes.buffer), 3));
  geometry.computeVertexNormals();
  return geometry;
}

function vector([x = 0, y = 0, z = 0]: readonly number[]): Vector3 {
  return new Vector3(x, y, z);
}
