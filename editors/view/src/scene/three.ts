// Conversions between poses and three.js.

import { type BufferGeometry, Color, CylinderGeometry, Float32BufferAttribute, Matrix4, Quaternion, Vector3 } from "three";
import type { Frame } from "../panels/pendant/pose";

export function matrixOf({ position: [x, y, z], rotation: [[a, b, c], [d, e, f], [g, h, i]] }: Frame): Matrix4 {
  return new Matrix4().set(a, b, c, x, d, e, f, y, g, h, i, z, 0, 0, 0, 1);
}

/** Sets the same colour at every corner of a geometry, so that parts with several colours are one mesh. */
export function coloured(geometry: BufferGeometry, colour: number): BufferGeometry {
  const { r, g, b } = new Color(colour);
  const count = geometry.getAttribute("position").count;
  geometry.setAttribute("color", new Float32BufferAttribute(Array.from({ length: count }, () => [r, g, b]).flat(), 3));
  return geometry;
}

/** Returns a truncated cone between two positions. */
export function rod(from: Vector3, to: Vector3, start: number, end: number): BufferGeometry {
  const way = to.clone().sub(from);
  const geometry = new CylinderGeometry(end, start, way.length(), 40);
  geometry.applyQuaternion(new Quaternion().setFromUnitVectors(new Vector3(0, 1, 0), way.clone().normalize()));
  const middle = from.clone().addScaledVector(way, 0.5);
  return geometry.translate(middle.x, middle.y, middle.z);
}
