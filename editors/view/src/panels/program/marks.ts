// Marks of program lines: the lines that tasks execute, and the line of the present move.

import type { TaskState } from "../tasks/chart";
import type { CodeLine, Program } from "./programs";

/** Line of the present move. */
export interface MovingLine extends CodeLine {
  instruction: string;
  /** Whether the arm is at rest, for example because the next move is missing or the arm has no power. */
  isWaiting: boolean;
}

/** Task at its line. */
export interface TaskMark {
  name: string;
  state: "running" | "waiting" | "suspended" | "error";
  /** Name with the state in a few words. */
  text: string;
  /** State with its reason. */
  title: string;
}

/** Marks of a line. */
export interface LineMarks {
  tasks: readonly TaskMark[];
  moving: MovingLine | undefined;
}

/** Returns the marks of a program by line. */
export function marksOf({ name, file }: Program, tasks: readonly TaskState[], moving: MovingLine | undefined): Map<number, LineMarks> {
  const marks = new Map<number, LineMarks>();
  const isHere = (line: CodeLine): boolean => line.program === name && line.file === file;
  for (const task of tasks.filter(isHere)) {
    const known = marks.get(task.line)?.tasks ?? [];
    marks.set(task.line, { tasks: [...known, markOf(task)], moving: undefined });
  }
  if (moving !== undefined && isHere(moving)) {
    marks.set(moving.line, { tasks: marks.get(moving.line)?.tasks ?? [], moving });
  }
  return marks;
}

function markOf({ name, state, waits, error }: TaskState): TaskMark {
  if (error !== null) {
    return { name, state: "error", text: `${name}: error ${error}`, title: `${name} has failed with error ${error}` };
  }
  if (waits !== null) {
    return { name, state: "waiting", text: `${name} waits`, title: `${name} waits for ${waits.replaceAll("`", "")}` };
  }
  return state === "suspended"
    ? { name, state, text: `${name} is suspended`, title: `${name} is suspended` }
    : { name, state: "running", text: name, title: `${name} executes this line` };
}

/** Returns the state that colours a line with several tasks: first a failed task counts, then an executing task. */
export function lineState(tasks: readonly TaskMark[]): TaskMark["state"] | undefined {
  return (["error", "running", "waiting", "suspended"] as const).find((state) => tasks.some((task) => task.state === state));
}
