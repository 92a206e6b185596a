// Lines between things that are too near to each other, with their distances.

import { Color } from "three";
import { distanceText, type Encounter, encountersAt, measuredNear } from "../panels/clearance/encounters";
import type { Label } from "./Labels";
import { Lines } from "./lines";
import { NEARNESS } from "./nearness";

export class NearPairs {
  private readonly lines = new Lines({ width: 3, isOnTop: true });
  readonly object = this.lines.object;
  labels: Label[] = [];

  /** Shows the pairs at a time, each with its distance measured nearest to this time. */
  place(encounters: readonly Encounter[], t: number): void {
    this.labels = [];
    this.lines.segments.clear();
    for (const encounter of encountersAt(encounters, t)) {
      const event = measuredNear(encounter, t);
      const [from, to] = event?.points ?? [];
      if (event !== undefined && from !== undefined && to !== undefined) {
        const { r, g, b } = new Color(NEARNESS[event.distance > 0 ? "near" : "contact"]);
        this.lines.segments.add(from, to, [r, g, b]);
        this.labels.push({ text: distanceText(event.distance), at: from.map((value, axis) => (value + (to[axis] ?? value)) / 2), kind: event.distance > 0 ? "near" : "contact" });
      }
    }
    this.lines.show();
  }
}
