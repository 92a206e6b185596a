// Jumps along the time: to errors and moves.

import type { RunEvent } from "../panels/tasks/eventText";
import { groupOf } from "../panels/tasks/eventText";

export type Target = "error" | "move";

/** Distance of a time that counts as another time, in s. */
const APART = 0.002;

/** Whether an event is an error, or the start of a move. */
function isTarget(event: RunEvent, target: Target): boolean {
  return target === "error" ? groupOf(event) === "errors" : event.kind === "move" && event["phase"] === "started";
}

/** Returns the time of the next error or move after a time, or of the previous one; `undefined` if there is none. */
export function jumpFrom(events: readonly RunEvent[], target: Target, t: number, isForward: boolean): number | undefined {
  return isForward
    ? events.find((event) => event.t > t + APART && isTarget(event, target))?.t
    : events.findLast((event) => event.t < t - APART && isTarget(event, target))?.t;
}
