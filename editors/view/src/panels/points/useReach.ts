// Reasons why the arm cannot reach points and joint positions with a tool.

import { useEffect, useState } from "preact/hooks";
import type { Answer, Cell } from "../shared/cell";
import { pointText } from "./edits";
import { type ChosenTool, toolArguments } from "./tools";

/** Time without changes after which the reach is computed again, in ms. */
const QUIET = 300;

/** Returns the reasons by name. A run that nobody can operate, or of an earlier version, has none. */
export function useReach(cell: Cell, tool: ChosenTool): ReadonlyMap<string, string> {
  const [reasons, setReasons] = useState<ReadonlyMap<string, string>>(new Map());
  const [points, joints, blocked] = [cell.points.value, cell.joints.value, cell.blocked.value];
  const toolName = tool === undefined ? cell.sample.value?.toolName : pointText(tool);
  useEffect(() => {
    let isCurrent = true;
    const ask = async (): Promise<void> => {
      const found = reasonsOf(await cell.send("reach", toolArguments(tool)));
      if (isCurrent) {
        setReasons(found);
      }
    };
    const timer = blocked === undefined ? setTimeout(() => void ask().catch(() => undefined), QUIET) : undefined;
    return () => {
      isCurrent = false;
      clearTimeout(timer);
    };
  }, [cell, points, joints, toolName, blocked]);
  return reasons;
}

/** Returns the reasons in a response of `reach`. */
export function reasonsOf(answer: Answer): ReadonlyMap<string, string> {
  const values = answer["unreachable"];
  return new Map((Array.isArray(values) ? values.filter(isUnreachable) : []).map((value) => [pointText(value), value.reason]));
}

function isUnreachable(value: unknown): value is { name: string; key: string | null; reason: string } {
  return typeof value === "object" && value !== null && "name" in value && "key" in value && "reason" in value;
}
