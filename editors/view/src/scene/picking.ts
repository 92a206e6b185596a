// The point or piece of the path at a place of the picture.

import { type Object3D, type PerspectiveCamera, Plane, Raycaster, Vector2, Vector3 } from "three";
import type { CellPoint } from "../panels/shared/cell";
import type { Piece, Trail } from "./trail";

const UP = new Vector3(0, 0, 1);

export type Picked = { at: readonly number[] } & ({ point: CellPoint } | { piece: Piece });

/** Distance in pixels at which something is still hit. */
const NEAR = 10;

export function pick(x: number, y: number, size: readonly [number, number], camera: PerspectiveCamera, points: readonly CellPoint[], trail: Trail): Picked | undefined {
  const place = new Vector3();
  const distance = ([px = 0, py = 0, pz = 0]: readonly number[]): number => {
    place.set(px, py, pz).project(camera);
    return place.z > 1 ? Infinity : Math.hypot((place.x + 1) * 0.5 * size[0] - x, (1 - place.y) * 0.5 * size[1] - y);
  };
  let [best, found]: [number, Picked | undefined] = [NEAR, undefined];
  for (const point of points) {
    const away = distance(point.pose);
    if (away < best) {
      [best, found] = [away, { at: point.pose, point }];
    }
  }
  for (let index = trail.lines.object.geometry.instanceCount - 1; found === undefined && index >= 0; index -= 1) {
    const [at, piece] = [trail.lines.end(index), trail.piece(index)];
    if (piece !== undefined && distance(at) < NEAR * 0.7) {
      found = { at, piece };
    }
  }
  return found;
}

/** The nearest place of a solid thing, or of the floor at its height, for measuring where no point is. */
export function surfaceAt(floor: number, x: number, y: number, [width, height]: readonly [number, number], camera: PerspectiveCamera, solid: Object3D | undefined): readonly number[] | undefined {
  const ray = new Raycaster();
  ray.setFromCamera(new Vector2((x / width) * 2 - 1, 1 - (y / height) * 2), camera);
  const hit = solid === undefined ? undefined : ray.intersectObject(solid, true)[0]?.point;
  return (hit ?? ray.ray.intersectPlane(new Plane(UP, -floor), new Vector3()))?.toArray();
}
