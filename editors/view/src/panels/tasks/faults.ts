// Faults of a run: errors that have stopped tasks, and paths that the arm cannot follow.

import type { RunEvent } from "./eventText";

export interface Fault {
  t: number;
  text: string;
  source: { program: string; line: number; file: string } | undefined;
  /** Id of the move whose path is impossible. */
  move: number | undefined;
}

const FAULTS: ReadonlySet<string> = new Set(["error", "fault", "lacking"]);

/** Returns the fault of an event; `undefined` if the event is no fault. */
export function faultOf(event: RunEvent): Fault | undefined {
  if (!FAULTS.has(event.kind)) {
    return undefined;
  }
  const [program, line, file, id] = [event["program"], event["line"], event["file"], event["id"]];
  const source = typeof program === "string" && typeof line === "number" ? { program, line, file: typeof file === "string" ? file : "" } : undefined;
  const at = source === undefined ? "" : ` at ${source.program}:${source.line}`;
  const task = event.task === undefined ? "" : ` in task ${event.task}`;
  return { t: event.t, text: `${causeOf(event)}${task}${at}`, source, move: event.kind === "fault" && typeof id === "number" ? id : undefined };
}

function causeOf(event: RunEvent): string {
  const word = (name: string): string => { const value = event[name]; return typeof value === "string" || typeof value === "number" ? String(value) : ""; };
  switch (event.kind) {
    case "error": return `Error ${word("code")}: ${word("message")}`;
    case "fault": return `The arm cannot follow the path of ${word("type")}: ${word("text")}`;
    default: return `${word("instruction")} is not available on this controller`;
  }
}
