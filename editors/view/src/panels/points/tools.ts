// Tool whose centre point is taught, and the configuration that a taught point gets.

import type { Cell, CellPoint, Pose } from "../shared/cell";
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

/** Tool with which the operator jogs and teaches, and whose centre point is read. */
export interface HandTool {
  /** Name of the tool; `undefined` if no data have the pose of the last move's tool. */
  name: string | undefined;
  pose: Pose;
  isOfLastMove: boolean;
}

/** Returns the chosen tool, otherwise the tool of the last move. */
export function handTool({ chosenTool, tools, sample }: Pick<Cell, "chosenTool" | "tools" | "sample">): HandTool {
  const [chosen, last] = [chosenTool.value, sample.value];
  const pose = chosenPose(chosen, tools.value);
  return chosen === undefined || pose === undefined
    ? { name: last?.toolName ?? undefined, pose: last?.tool ?? [], isOfLastMove: true }
    : { name: pointText(chosen), pose, isOfLastMove: false };
}
