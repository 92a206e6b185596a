// Tool whose centre point is taught, and the configuration that a taught point gets.

import type { CellPoint, Pose } from "../shared/cell";
import { type PointName, pointText, samePoint } from "./edits";

/** Tool; `undefined` for the tool of the last move. */
export type ChosenTool = PointName | undefined;

export const FLANGE: PointName = { name: "flange", key: null };

/** Arguments of `teach` and `solve` for a tool. */
export function toolArguments(tool: ChosenTool): { tool?: PointName } {
  return tool === undefined ? {} : { tool: { name: tool.name, key: tool.key } };
}

/** Returns the text about a tool: `tGripper`, or `the last move's tool` if its name is unknown. */
export function toolText(tool: ChosenTool, lastTool: string | null | undefined): string {
  return tool === undefined ? lastTool ?? "the last move's tool" : pointText(tool);
}

/** Returns the words of a point's configuration after teaching: the arm's present words, except that `ssame`, `esame` and `wsame` are kept. */
export function taughtConfig(point: string | null | undefined, arm: string | undefined): string[] {
  const words = (text: string | null | undefined): string[] => (text ?? "").split(" ").filter((word) => word !== "");
  const present = words(point);
  return words(arm).map((word, index) => (present[index]?.endsWith("same") === true ? present[index] : word));
}

/** Returns the pose of a chosen tool on the flange; `undefined` for the tool of the last move. */
export function chosenPose(tool: ChosenTool, tools: readonly CellPoint[]): Pose | undefined {
  return tool === undefined ? undefined : samePoint(tool, FLANGE) ? [] : tools.find((candidate) => samePoint(candidate, tool))?.pose;
}
