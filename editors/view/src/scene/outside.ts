// Places at the border of the picture for the names of positions outside it.

import { Vector3 } from "three";
import type { Lens } from "./Camera";

/** Direction on the screen: to the right and down, of length 1. */
export type Direction = readonly [across: number, down: number];

const ARROWS = ["→", "↘", "↓", "↙", "←", "↖", "↑", "↗"];

/** Shares of the way from the centre to the border, from the border on. */
const SHARES = Array.from({ length: 15 }, (_, index) => 1 - index * 0.05);

/** Returns the direction from the centre of the picture to a position, which may be behind the camera. */
export function directionTo([x = 0, y = 0, z = 0]: readonly number[], camera: Lens): Direction {
  const seen = new Vector3(x, y, z).applyMatrix4(camera.matrixWorldInverse);
  const length = Math.hypot(seen.x, seen.y);
  return length < 1e-6 ? [0, 1] : [seen.x / length, -seen.y / length];
}

/** Returns the arrow nearest to a direction. */
export function arrow([across, down]: Direction): string {
  const eighth = Math.round((Math.atan2(down, across) / (2 * Math.PI)) * 8);
  return ARROWS[(eighth + 8) % 8] ?? "";
}

/** Returns places for a box in a picture: on the line from the centre in a direction, from the border inwards. */
export function placesTowards([across, down]: Direction, picture: readonly [width: number, height: number], box: readonly [width: number, height: number]): (readonly [x: number, y: number])[] {
  const half = [Math.max(picture[0] - box[0], 0) / 2, Math.max(picture[1] - box[1], 0) / 2] as const;
  const reach = Math.min(half[0] / Math.max(Math.abs(across), 1e-9), half[1] / Math.max(Math.abs(down), 1e-9));
  return SHARES.map((share) => [Math.round(half[0] + across * reach * share), Math.round(half[1] + down * reach * share)]);
}
