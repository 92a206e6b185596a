// Finds the point or path piece at a location in the drawing.

import { type Object3D, Plane, Raycaster, Vector2, Vector3 } from "three";
import type { CellPoint } from "../panels/shared/cell";
import type { Lens } from "./Camera";
import type { Piece, Trail } from "./trail";

const UP = new Vector3(0, 0, 1);

export type Picked = { at: readonly number[] } & ({ point: CellPoint } | { piece: Piece; t: number });

/** Largest distance in pixels at which something is hit. */
const NEAR = 10;

export function pick(x: number, y: number, size: readonly [number, number], camera: Lens, points: readonly CellPoint[], trail: Trail): Picked | undefined {
  const place = new Vector3();
  const onScreen = (at: ArrayLike<number>): readonly [number, number] => {
    place.set(at[0] ?? 0, at[1] ?? 0, at[2] ?? 0).project(camera);
    return place.z > 1 ? [Infinity, Infinity] : [(place.x + 1) * 0.5 * size[0], (1 - place.y) * 0.5 * size[1]];
  };
  const distance = (at: ArrayLike<number>): number => {
    const [across, down] = onScreen(at);
    return Math.hypot(across - x, down - y);
  };
  let [best, found]: [number, Picked | undefined] = [NEAR, undefined];
  for (const point of points) {
    const away = distance(point.pose);
    if (away < best) {
      [best, found] = [away, { at: point.pose, point }];
    }
  }
  for (let index = trail.shown - 1; found === undefined && index >= 0; index -= 1) {
    const [[from, to], piece] = [trail.segments.at(index), trail.piece(index)];
    if (piece !== undefined) {
      const share = nearestShare(onScreen(from), onScreen(to), [x, y]);
      const at = [0, 1, 2].map((axis) => (from[axis] ?? 0) + ((to[axis] ?? 0) - (from[axis] ?? 0)) * share);
      if (distance(at) < NEAR * 0.7) {
        found = { at, piece, t: piece.from + (piece.t - piece.from) * share };
      }
    }
  }
  return found;
}

/** Returns the fraction of the segment between two locations that is nearest to a third one. */
export function nearestShare([ax, ay]: readonly [number, number], [bx, by]: readonly [number, number], [x, y]: readonly [number, number]): number {
  const square = (bx - ax) ** 2 + (by - ay) ** 2;
  return square > 0 && square < Infinity ? Math.min(Math.max(((x - ax) * (bx - ax) + (y - ay) * (by - ay)) / square, 0), 1) : 0;
}

/** Returns the nearest position on solids, or on the floor at its height, for measurements where no point is. */
export function surfaceAt(floor: number, x: number, y: number, [width, height]: readonly [number, number], camera: Lens, solids: readonly (Object3D | undefined)[]): readonly number[] | undefined {
  const ray = new Raycaster();
  ray.setFromCamera(new Vector2((x / width) * 2 - 1, 1 - (y / height) * 2), camera);
  const hit = ray.intersectObjects(solids.filter((solid) => solid !== undefined), true)[0]?.point;
  return (hit ?? ray.ray.intersectPlane(new Plane(UP, -floor), new Vector3()))?.toArray();
}
