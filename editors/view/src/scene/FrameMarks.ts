// Axes of world, the base, frames and tools, with their names.

import { Color } from "three";
import { composed, type Frame, frameOf, IDENTITY } from "../panels/pendant/pose";
import { pointText } from "../panels/points/edits";
import { handTool } from "../panels/points/tools";
import type { Cell, Pose } from "../panels/shared/cell";
import type { Selection } from "../store";
import type { Label } from "./Labels";
import { Lines } from "./lines";
import { AXES, type Look } from "./palette";

/** Shown state of the arm. */
interface Placed {
  cell: Pick<Cell, "frames" | "tools" | "chosenTool" | "sample">;
  selection: Selection | undefined;
  flange: Frame;
  base: Frame;
  hasFrames: boolean;
}

export class FrameMarks {
  private readonly lines = new Lines({ width: 2.4 });
  readonly object = this.lines.object;
  labels: Label[] = [];

  /** Draws the axes. `size` is the length of the arm in mm. */
  place({ cell, selection, flange, base, hasFrames }: Placed, size: number, look: Look): void {
    this.lines.segments.clear();
    this.labels = [];
    this.triad(IDENTITY, size * 0.32);
    if (Math.hypot(...base.position) > 1) {
      this.triad(base, size * 0.2);
    }
    for (const { pose, ...frame } of hasFrames ? cell.frames.value : []) {
      const name = pointText(frame);
      const isSelected = selection?.kind === "frame" && selection.name === name;
      this.triad(frameOf(pose), size * (isSelected ? 0.24 : 0.13));
      this.labels.push({ text: name, at: pose, kind: isSelected ? "selected" : "frame" });
    }
    const selected = selection?.kind === "tool" ? selection.name : undefined;
    const { r, g, b } = new Color(look.joint);
    for (const [name, pose] of shownTools(cell, selected)) {
      const at = composed(flange, frameOf(pose));
      this.lines.segments.add(flange.position, at.position, [r, g, b]);
      this.triad(at, size * 0.11);
      this.labels.push({ text: name, at: at.position, kind: name === selected ? "selected" : "tool" });
    }
    this.lines.show();
  }

  private triad({ position, rotation }: Frame, length: number): void {
    AXES.forEach((colour, axis) => {
      const end = position.map((value, row) => value + length * (rotation[row]?.[axis] ?? 0));
      const { r, g, b } = new Color(colour);
      this.lines.segments.add(position, end, [r, g, b]);
    });
  }
}

/** Returns the tool of the last move, the tool for jogging and teaching, and the selected tool, by name. */
export function shownTools(cell: Pick<Cell, "tools" | "chosenTool" | "sample">, selected: string | undefined): ReadonlyMap<string, Pose> {
  const { sample, tools } = cell;
  const hand = handTool(cell);
  const shown = new Map([[sample.value?.toolName ?? "TCP", sample.value?.tool ?? []], [hand.name ?? "TCP", hand.pose]]);
  const other = tools.value.find((tool) => pointText(tool) === selected);
  return other === undefined ? shown : shown.set(pointText(other), other.pose);
}
