// Waits of tasks in sentences, the most important first.

import type { TaskState } from "../panels/tasks/chart";

/** Tasks that are named in a sentence. */
const NAMED = 2;

/** Greatest number of characters for a condition in a sentence. */
const LONGEST = 80;

/** Waits by importance: for something outside the program, for the arm, for time. */
export const [OUTSIDE, ARM, TIME] = [0, 1, 2] as const;

/** Returns what a task waits for, in general. */
export function importanceOf(thing: string): typeof OUTSIDE | typeof ARM | typeof TIME {
  return /^(?:time\b|a file$)/.test(thing) ? TIME : /^the arm\b/.test(thing) ? ARM : OUTSIDE;
}

function importance({ waits, awaits }: TaskState): number {
  return importanceOf(awaits ?? waits ?? "");
}

/** Whether the task waits for an arm that moves. */
export function awaitsMovingArm(task: TaskState): boolean {
  return task.waits !== null && importance(task) === ARM && (task.awaits ?? task.waits) === task.waits;
}

/** Returns the condition of `wait(…)` in the code of a line; `undefined` without a condition. */
export function conditionOf(code: string | null | undefined): string | undefined {
  const [, condition] = /^wait\s*\((.*)\)\s*(?:\/\/.*)?$/i.exec(code ?? "") ?? [];
  return condition?.trim();
}

/** Returns a sentence about what tasks wait for, with their lines. */
export function waitsText(tasks: readonly TaskState[]): string {
  const waiting = tasks.filter(({ waits }) => waits !== null)
    .sort((left, right) => importance(left) - importance(right) || (right.priority ?? Infinity) - (left.priority ?? Infinity) || 0);
  const named = waiting.slice(0, NAMED).map((task) => `${task.name} waits for ${thingOf(task)} at ${task.program}:${task.line}`);
  const more = waiting.length - named.length;
  return named.length === 0 ? "" : `${named.join("; ")}${more === 0 ? "" : `; and ${more} more`}.`;
}

function thingOf({ waits, awaits, lineCode }: TaskState): string {
  const thing = (awaits ?? waits ?? "").replaceAll("`", "");
  const condition = /^a condition\b/.test(thing) ? conditionOf(lineCode) : undefined;
  return condition === undefined ? thing : condition.length > LONGEST ? `${condition.slice(0, LONGEST)}…` : condition;
}
