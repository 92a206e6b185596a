// Reasons why the arm cannot reach points and joint positions, for the tables and the picture: with the last move's tool
// from the messages of the run, and with a tool that an operator has chosen from the server.

import { effect } from "@preact/signals";
import type { Answer, Cell } from "../shared/cell";
import { pointText } from "./edits";
import { toolArguments } from "./tools";

/** Reasons by name. */
export type Reasons = ReadonlyMap<string, string>;

/** Reach of a tool. */
export interface ToolReach {
  /** Name of the tool; `undefined` if no data have its pose. */
  tool: string | undefined;
  reasons: Reasons;
}

/** Time without changes after which the reach of the chosen tool is computed again, in ms. */
const QUIET = 300;

/** Requests the reasons for the chosen tool after each change, until the returned function is called. */
export function followReach(cell: Cell): () => void {
  let newest = 0;
  const request = async (): Promise<void> => {
    newest += 1;
    const own = newest;
    const tool = cell.chosenTool.peek();
    const reasons = reasonsOf((await cell.send("reach", toolArguments(tool)))["unreachable"]);
    if (own === newest && tool !== undefined) {
      cell.chosenReach.value = { tool: pointText(tool), reasons };
    }
  };
  return effect(() => {
    const { points, joints, tools, chosenTool, blocked } = cell;
    [points, joints, tools].forEach((changing) => changing.valueOf());
    if (chosenTool.value === undefined || blocked.value !== undefined) {
      newest += 1;
      cell.chosenReach.value = undefined;
      return undefined;
    }
    const timer = setTimeout(() => void request().catch(() => undefined), QUIET);
    return () => clearTimeout(timer);
  });
}

/** Returns the reasons in a list of unreachable values. */
export function reasonsOf(values: Answer[string]): Reasons {
  return new Map((Array.isArray(values) ? values.filter(isUnreachable) : []).map((value) => [pointText(value), value.reason]));
}

function isUnreachable(value: unknown): value is { name: string; key: string | null; reason: string } {
  return typeof value === "object" && value !== null && "name" in value && "key" in value && "reason" in value;
}
