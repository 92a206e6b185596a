// Values of points at a time: the values in the scene, and the changes up to the time.

import type { CellPoint } from "../shared/cell";
import type { DataMessage } from "../shared/messages";
import { countUpTo } from "../tasks/upTo";
import { pointText } from "./edits";

/** Caches the last result, because most times show the same values. */
export class PointValues {
  private points: readonly CellPoint[] = [];
  private readonly changes: DataMessage[] = [];
  private count = -1;
  private shown: readonly CellPoint[] = [];

  restart(points: readonly CellPoint[]): void {
    this.points = points;
    this.changes.length = 0;
    this.count = -1;
  }

  add(message: DataMessage): void {
    this.changes.push(message);
  }

  at(t: number): readonly CellPoint[] {
    const count = countUpTo(this.changes, t);
    if (count !== this.count) {
      this.count = count;
      const changed = new Map(this.changes.slice(0, count).flatMap(({ points }) => points).map((point) => [pointText(point), point]));
      this.shown = this.points.map((point) => ({ ...point, ...changed.get(pointText(point)) }));
    }
    return this.shown;
  }
}
