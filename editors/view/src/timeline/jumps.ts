// Jumps along the time: to errors, moves, and things that come too near to each other.

import type { RunEvent } from "../panels/tasks/eventText";
import { groupOf } from "../panels/tasks/eventText";

export type Target = "error" | "move" | "near";

/** Times that differ by less than this are the same time for a jump, in s. */
const APART = 0.002;

/** Whether an event is an error, a move start, or the beginning of an encounter or contact. */
function isTarget(event: RunEvent, target: Target): boolean {
  switch (target) {
    case "error": return groupOf(event) === "errors";
    case "move": return event.kind === "move" && event["phase"] === "started";
    case "near": return event.kind === "clearance" && event["state"] !== "clear";
  }
}

/** Returns the time of the next target after a time, or of the previous one; `undefined` without such a target. */
export function jumpFrom(events: readonly RunEvent[], target: Target, t: number, isForward: boolean): number | undefined {
  return isForward
    ? events.find((event) => event.t > t + APART && isTarget(event, target))?.t
    : events.findLast((event) => event.t < t - APART && isTarget(event, target))?.t;
}
