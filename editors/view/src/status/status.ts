// Status of the run in one sentence for the user: its present activity, or the reason why the arm does not move.

import type { CellState } from "../panels/shared/cell";
import type { TaskState } from "../panels/tasks/chart";
import { awaitsMovingArm, conditionOf, waitsText } from "./waits";

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
  /** Time that the user has chosen, if its messages are not there yet. */
  awaited: number | undefined;
  /** Whether the page is in an editor. */
  isInEditor: boolean;
  state: CellState | undefined;
}

/** Failed tasks that are named in a sentence. */
const NAMED = 2;

const NO_POWER = "The arm has no power. Switch the power on.";

export function statusOf({ lost, end, role, isPast, isPaused, isStopped, isSilent, awaited, isInEditor, state }: StatusFacts): Status {
  if (lost !== undefined) {
    return { kind: "fault", text: lost, word: "no connection" };
  }
  if (isSilent && end === undefined) {
    return { kind: "fault", text: "No answer from the server for 3 s. It is stopped or overloaded.", word: "no answer" };
  }
  if (awaited !== undefined) {
    return { kind: "waiting", text: `The run at ${awaited.toFixed(1)} s is still being loaded. Until then, the oldest loaded time is shown.`, word: "loading" };
  }
  if (role === undefined || role === "preview") {
    const missing = isInEditor ? "No application is shown. Open one of its files in the editor." : "The run has not begun.";
    return { kind: "stopped", text: role === undefined ? missing : "The application does not run.", word: "not running" };
  }
  // A recording shows the state at the shown time.
  const present: Status = state === undefined ? { kind: "running", text: "", word: "running" } : stateStatus(state, role);
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

/** Returns the state of the robot and its tasks: first the tasks that have failed. */
function stateStatus(state: CellState, role: string): Status {
  const failed = state.tasks.filter(({ error }) => error !== null);
  if (failed.length > 0 && failed.length === state.tasks.length) {
    return { kind: "fault", text: `${failed.length === 1 ? failedText(failed) : "All tasks have failed."} ${remedy(role)}`.trim(), word: "fault" };
  }
  const live = { ...state, tasks: state.tasks.filter(({ error }) => error === null) };
  const present = robotStatus(live) ?? armStatus(live);
  return failed.length === 0 ? present : { kind: "fault", text: `${failedText(failed)} ${present.text}`, word: "fault" };
}

function failedText(failed: readonly TaskState[]): string {
  const named = failed.slice(0, NAMED).map(({ name, error, program, line }) => `${name} has failed with error ${error} at ${program}:${line}`);
  const more = failed.length - named.length;
  return `${named.join("; ")}${more === 0 ? "" : `; and ${more} more`}.`;
}

/** Returns how the user starts the application again after all tasks have failed. */
function remedy(role: string): string {
  switch (role) {
    case "operator": return "Press Run to start the application again.";
    case "debugger": return "Restart the application in the editor.";
    default: return "";
  }
}

/** Returns why the arm does not move, if a task waits for it or moves are recorded. */
function robotStatus({ power, emergencyStop, awaitedHold, heldBecause, tasks }: CellState): Status | undefined {
  if (emergencyStop === "open") {
    return { kind: "stopped", text: "The E-stop is pressed. Release it, then switch the power on.", word: "E-stop" };
  }
  // The reason why the arm does not move is part of what these tasks wait for.
  const held = tasks.filter(({ waits, awaits }) => awaits != null && waits !== awaits);
  if (awaitedHold != null) {
    return { kind: "stopped", text: `${awaitedHold} ${waitsText(held)}`.trim(), word: "arm held" };
  }
  const unpowered = power ? [] : tasks.filter(awaitsPower);
  if (unpowered.length > 0) {
    return { kind: "stopped", text: `${NO_POWER} ${waitsText(unpowered)}`, word: "no power" };
  }
  return heldBecause == null ? undefined : { kind: "stopped", text: `${heldBecause} ${taskStatus(tasks).text}`, word: "arm held" };
}

/** Returns the activity of the tasks, and what the arm waits for. */
function armStatus(state: CellState): Status {
  const status = taskStatus(state.tasks);
  return { ...status, text: `${status.text} ${armText(state)}`.trim() };
}

/** Returns what an arm without recorded moves, or at the end of them, waits for. */
function armText({ isHeld, mode, emergencyStop, awaitsNextMove }: CellState): string {
  if (emergencyStop !== "open" && isHeld) {
    return mode === "remote" ? "The arm is held. Press Move." : `Held in ${mode} mode.`;
  }
  return awaitsNextMove === true ? "The arm waits for the next move." : "";
}

function awaitsPower({ waits, lineCode }: TaskState): boolean {
  const condition = waits === null ? undefined : conditionOf(lineCode);
  return condition !== undefined && /\bisPowered\s*\(/i.test(condition) && !/(?:!|\bnot\b)\s*isPowered\b/i.test(condition);
}

function taskStatus(tasks: readonly TaskState[]): Status {
  if (tasks.length === 0) {
    return { kind: "stopped", text: "No task exists.", word: "no task" };
  }
  if (tasks.some(({ waits, state }) => waits === null && state !== "suspended")) {
    return { kind: "running", text: "Running.", word: "running" };
  }
  return tasks.some(awaitsMovingArm)
    ? { kind: "running", text: `The arm moves. ${waitsText(tasks)}`, word: "running" }
    : { kind: "waiting", text: waitsText(tasks) || "All tasks are suspended.", word: "waiting" };
}
