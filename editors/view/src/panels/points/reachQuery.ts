// Reasons why the arm cannot reach points and joint positions with the chosen tool, for the tables and the picture.

import { effect } from "@preact/signals";
import type { Answer, Cell } from "../shared/cell";
import { pointText } from "./edits";
import { toolArguments } from "./tools";

/** Time without changes after which the reach is computed again, in ms. */
const QUIET = 300;

/** Requests the reasons after each change, until the returned function is called. Runs that cannot be operated or are of an earlier version have no reasons. */
export function followReach(cell: Cell): () => void {
  let newest = 0;
  const request = async (): Promise<void> => {
    newest += 1;
    const own = newest;
    const reasons = reasonsOf(await cell.send("reach", toolArguments(cell.chosenTool.peek())));
    if (own === newest) {
      cell.unreachable.value = reasons;
    }
  };
  return effect(() => {
    const { points, joints, tools, chosenTool, toolName, blocked } = cell;
    [points, joints, tools, chosenTool, toolName].forEach((changing) => changing.valueOf());
    const hasPositions = points.value.length + joints.value.length > 0;
    const timer = hasPositions && blocked.value === undefined ? setTimeout(() => void request().catch(() => undefined), QUIET) : undefined;
    return () => clearTimeout(timer);
  });
}

/** Returns the reasons in a response of `reach`. */
export function reasonsOf(answer: Answer): ReadonlyMap<string, string> {
  const values = answer["unreachable"];
  return new Map((Array.isArray(values) ? values.filter(isUnreachable) : []).map((value) => [pointText(value), value.reason]));
}

function isUnreachable(value: unknown): value is { name: string; key: string | null; reason: string } {
  return typeof value === "object" && value !== null && "name" in value && "key" in value && "reason" in value;
}
