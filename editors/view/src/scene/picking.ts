// The point or piece of the path at a place of the picture.

import { type PerspectiveCamera, Vector3 } from "three";
import type { CellPoint } from "../panels/shared/cell";
import type { Piece, Trail } from "./trail";

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
