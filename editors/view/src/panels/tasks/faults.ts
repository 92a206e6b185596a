// Faults of a run: errors that have stopped tasks, and paths that the arm cannot follow.

import type { RunEvent } from "./eventText";

export interface Fault {
  t: number;
  text: string;
  /** Code of the line. */
  code?: string | undefined;
  /** Reason why a move was rejected. */
  reason?: string | undefined;
  /** Explanation and remedy. */
  help?: string | undefined;
  source: { program: string; line: number; file: string } | undefined;
  /** Id of the move whose path is impossible. */
  move: number | undefined;
}

const FAULTS: ReadonlySet<string> = new Set(["error", "fault", "lacking"]);

/** Remedy for a path that the arm cannot follow. */
const CORRECT_PATH = "The arm stops before the path, and isEmpty() stays false. Correct the move; resetMotion clears the queue.";

/** Returns the fault that an event reports; `undefined` if it reports none. */
export function faultOf(event: RunEvent): Fault | undefined {
  if (!FAULTS.has(event.kind)) {
    return undefined;
  }
  const [line, id] = [event["line"], event["id"]];
  const program = textIn(event, "program");
  const source = program !== undefined && typeof line === "number" ? { program, line, file: textIn(event, "file") ?? "" } : undefined;
  const at = source === undefined ? "" : ` at ${source.program}:${source.line}`;
  const task = event.task === undefined ? "" : ` in task ${event.task}`;
  return {
    t: event.t, text: `${causeOf(event)}${task}${at}`, source, code: textIn(event, "lineCode"),
    reason: textIn(event, "reason"), help: event.kind === "fault" ? CORRECT_PATH : textIn(event, "help")?.replaceAll("`", ""),
    move: event.kind === "fault" && typeof id === "number" ? id : undefined,
  };
}

function textIn(event: RunEvent, name: string): string | undefined {
  const value = event[name];
  return typeof value === "string" && value !== "" ? value : undefined;
}

function causeOf(event: RunEvent): string {
  const word = (name: string): string => { const value = event[name]; return typeof value === "string" || typeof value === "number" ? String(value) : ""; };
  switch (event.kind) {
    case "error": return `Error ${word("code")}: ${word("message")}`;
    case "fault": return `The arm cannot follow the path of ${word("type")}: ${word("text")}`;
    default: return `${word("instruction")} is not available on this controller`;
  }
}
