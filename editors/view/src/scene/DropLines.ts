// Vertical lines from positions to the floor, which show the point of the floor that each position is above.

import { Color } from "three";
import type { Look } from "./palette";
import { Lines } from "./lines";

/** Largest number of lines. Without this limit, thousands of points would cover the drawing. */
const MOST = 200;

export class DropLines {
  private readonly lines = new Lines({ width: 1, opacity: 0.55 });
  readonly object = this.lines.object;

  /** Draws lines to the floor at its height, which end in crosses of this size. Lengths are in mm. */
  place(positions: readonly (readonly number[])[], floor: number, size: number, look: Look): void {
    const { r, g, b } = new Color(look.point);
    const { segments } = this.lines;
    segments.clear();
    for (const [x = 0, y = 0, z = 0] of positions.slice(0, MOST)) {
      if (Math.abs(z - floor) > 1) {
        segments.add([x, y, z], [x, y, floor], [r, g, b]);
        segments.add([x - size, y, floor], [x + size, y, floor], [r, g, b]);
        segments.add([x, y - size, floor], [x, y + size, floor], [r, g, b]);
      }
    }
    this.lines.show();
  }
}
