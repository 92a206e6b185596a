// Values of points or joint positions at a time: the values in the scene, and the changes up to the time.

import type { DataMessage } from "../shared/messages";
import { countUpTo } from "../tasks/upTo";
import { type PointName, pointText } from "./edits";

/** Caches the last result, because most times show the same values. */
export class DataValues<Value extends PointName> {
  private values: readonly Value[] = [];
  private readonly changes: DataMessage[] = [];
  private count = -1;
  private shown: readonly Value[] = [];

  /** Selects the changed values in a message. A changed value may omit constant properties. */
  constructor(private readonly valuesOf: (message: DataMessage) => readonly (Partial<Value> & PointName)[]) {}

  restart(values: readonly Value[]): void {
    this.values = values;
    this.changes.length = 0;
    this.count = -1;
  }

  add(message: DataMessage): void {
    this.changes.push(message);
  }

  at(t: number): readonly Value[] {
    const count = countUpTo(this.changes, t);
    if (count !== this.count) {
      this.count = count;
      const changed = new Map(this.changes.slice(0, count).flatMap(this.valuesOf).map((value) => [pointText(value), value]));
      this.shown = this.values.map((value) => ({ ...value, ...changed.get(pointText(value)) }));
    }
    return this.shown;
  }
}
