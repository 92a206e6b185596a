// Positions of the arm from which a frame or the centre point of a tool is computed.

import type { Answer } from "../shared/cell";
import { lengthText, type LengthUnit } from "../shared/lengths";
import type { PointName } from "./edits";
import { type ChosenTool, toolArguments } from "./tools";

export type TaughtKind = "frame" | "tool";

/** Joints of the arm by position; `undefined` for a position that was not taught. */
export type TaughtJoints = readonly (readonly number[] | undefined)[];

/** Names of the positions. */
export const POSITIONS: Readonly<Record<TaughtKind, readonly string[]>> = {
  frame: ["Origin", "On the x axis", "In the xy plane"],
  tool: ["Position 1", "Position 2", "Position 3", "Position 4"],
};

export const HINTS: Readonly<Record<TaughtKind, string>> = {
  frame: "Move the tool centre point to the origin, to the positive side of x, and to the positive side of y. Positions need a distance of 10 mm.",
  tool: "Touch the same place with the tip of the tool from four directions, which turn the flange about two axes. The orientation of the tool stays.",
};

/** Returns the command that computes the value, or the name of a position that was not taught. */
export function teachingCommand(kind: TaughtKind, { name, key }: PointName, tool: ChosenTool, joints: TaughtJoints): { command: string; args: object } | { missing: string } {
  const missing = POSITIONS[kind].find((_, index) => joints[index] === undefined);
  if (missing !== undefined) {
    return { missing };
  }
  return kind === "frame"
    ? { command: "teachFrame", args: { name, key, joints, ...toolArguments(tool) } }
    : { command: "teachTool", args: { name, key, joints } };
}

/** Returns the sentence about a computed value. */
export function taughtText(kind: TaughtKind, answer: Answer, unit: LengthUnit): string {
  const residual = answer["residual"];
  return kind === "tool" && typeof residual === "number" ? `Computed; the tip is at most ${lengthText(residual, 3, unit)} from the touched place.` : "Computed.";
}
