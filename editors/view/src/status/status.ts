// Status of the run in one sentence for the user: its present activity, or the reason why the arm does not move.

import type { CellState } from "../panels/shared/cell";
import type { TaskState } from "../panels/tasks/chart";

export interface Status {
  kind: "fault" | "stopped" | "waiting" | "running";
  text: string;
  /** Word for the title of the window. */
  word: string;
}

export interface StatusFacts {
  lost: string | undefined;
  end: string | undefined;
  role: string | undefined;
  isPast: boolean;
  isPaused: boolean;
  /** Whether a debugger has stopped the run. */
  isStopped: boolean;
  /** Whether the server does not answer. */
  isSilent: boolean;
  state: CellState | undefined;
}

/** Tasks that are named in a sentence. */
const NAMED = 2;

export function statusOf({ lost, end, role, isPast, isPaused, isStopped, isSilent, state }: StatusFacts): Status {
  if (lost !== undefined) {
    return { kind: "fault", text: lost, word: "no connection" };
  }
  if (isSilent && end === undefined) {
    return { kind: "fault", text: "No answer from the server for 3 s. It is stopped or overloaded.", word: "no answer" };
  }
  if (role === undefined || role === "preview") {
    return { kind: "stopped", text: role === undefined ? "The run has not begun." : "The application does not run.", word: "not running" };
  }
  // A recording shows the state at each of its times.
  const present: Status = state === undefined ? { kind: "running", text: "", word: "running" } : (robotStatus(state) ?? taskStatus(state.tasks));
  if (role === "recording") {
    return { ...present, word: "recording" };
  }
  if (isPast) {
    return { kind: "stopped", text: "You are looking at the past.", word: "past" };
  }
  if (end !== undefined) {
    const remedy = role === "operator" ? " Press Run to start the application again." : "";
    return { kind: "stopped", text: `The run has ended: ${end}.${remedy}`, word: "ended" };
  }
  if (isPaused || isStopped) {
    return isStopped || role === "debugger"
      ? { kind: "stopped", text: "The debugger has stopped the run.", word: "stopped" }
      : { kind: "stopped", text: "The run is paused. Press Play to continue.", word: "paused" };
  }
  return present;
}

/** Returns why the arm does not move, if a task waits for it. */
function robotStatus({ emergencyStop, awaitedHold, tasks }: CellState): Status | undefined {
  if (emergencyStop === "open") {
    return { kind: "stopped", text: "The E-stop is pressed. Release it, then switch the power on.", word: "E-stop" };
  }
  // The reason why the arm does not move is part of what these tasks wait for.
  const held = tasks.filter(({ waits, awaits }) => awaits != null && waits !== awaits);
  return awaitedHold == null ? undefined : { kind: "stopped", text: `${awaitedHold} ${waitsText(held)}`.trim(), word: "arm held" };
}

function taskStatus(tasks: readonly TaskState[]): Status {
  const failed = tasks.filter(({ error }) => error !== null);
  if (failed.length > 0 && failed.length === tasks.length) {
    return { kind: "fault", text: "All tasks have failed.", word: "fault" };
  }
  const live = tasks.filter(({ error }) => error === null);
  if (live.length === 0) {
    return { kind: "stopped", text: "No task exists.", word: "no task" };
  }
  return live.every(({ waits, state }) => waits !== null || state === "suspended")
    ? { kind: "waiting", text: waitsText(live) || "All tasks are suspended.", word: "waiting" }
    : { kind: "running", text: "Running.", word: "running" };
}

/** Returns a sentence about what tasks wait for, with their lines. */
export function waitsText(tasks: readonly TaskState[]): string {
  const waiting = tasks.filter(({ waits }) => waits !== null);
  const named = waiting.slice(0, NAMED).map(({ name, waits, awaits, program, line }) => `${name} waits for ${awaits ?? waits ?? ""} at ${program}:${line}`);
  const more = waiting.length - named.length;
  return named.length === 0 ? "" : `${named.join("; ")}${more === 0 ? "" : `; and ${more} more`}.`.replaceAll("`", "");
}
