// Position to which the operator is about to move the arm by hand: the lines of the arm there, and its tool.

import { Color } from "three";
import { armFrames } from "../kinematics";
import { composed, type Frame, frameOf } from "../panels/pendant/pose";
import type { ArmGoal, Pose } from "../panels/shared/cell";
import type { Scene } from "../protocol";
import { armLines } from "./armLines";
import type { Label } from "./Labels";
import { Lines } from "./lines";
import { AXES, type Look } from "./palette";

export class ArmGhost {
  private readonly arm = new Lines({ width: 9, opacity: 0.5, isOnTop: true });
  private readonly tool = new Lines({ width: 3, isOnTop: true });
  readonly objects = [this.arm.object, this.tool.object];
  labels: Label[] = [];

  /** Draws the arm at its goal; nothing without a goal. `size` is the length of the tool's axes in mm. */
  place(cell: Pick<Scene, "arm" | "base">, goal: ArmGoal | undefined, tool: Pose, size: number, look: Look): void {
    this.arm.segments.clear();
    this.tool.segments.clear();
    this.labels = [];
    if (goal !== undefined) {
      const { r, g, b } = new Color(look.selected);
      const { lines, flange, centre } = ghostLines(cell, goal.joints, tool);
      lines.forEach(([from, to]) => this.arm.segments.add(from, to, [r, g, b]));
      this.tool.segments.add(flange.position, centre.position, [r, g, b]);
      AXES.forEach((colour, axis) => {
        const { r: red, g: green, b: blue } = new Color(colour);
        this.tool.segments.add(centre.position, centre.position.map((value, row) => value + size * (centre.rotation[row]?.[axis] ?? 0)), [red, green, blue]);
      });
      this.labels = [{ text: `Go to ${goal.text}`, at: centre.position, kind: "selected" }];
    }
    this.arm.show();
    this.tool.show();
  }
}

/** Returns the arm lines in `world` for joints, the flange, and the tool centre point. */
export function ghostLines(cell: Pick<Scene, "arm" | "base">, joints: readonly number[], tool: Pose): { lines: ReturnType<typeof armLines>; flange: Frame; centre: Frame } {
  const base = frameOf(cell.base);
  const frames = armFrames(cell.arm, base, joints);
  return { lines: armLines(cell.arm, base, frames), flange: frames.flange, centre: composed(frames.flange, frameOf(tool)) };
}
