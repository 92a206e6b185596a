// Values of a variable in chronological order.

import type { History, Write } from "./messages";

/** A value of the variable, from its time until the next step. */
export interface Step {
  /** Time since the start of the run, in seconds. */
  t: number;
  value: string;
  /** Numbers of the value; `null` if a number is not finite. Empty if the value is not in memory. */
  numbers: readonly (number | null)[];
  /** The write; `undefined` for the value before all writes. */
  write: Write | undefined;
}

/** Returns the value before all writes, if it is known, and the writes, the oldest first. */
export function stepsOf({ writes, initial, initialNumbers, since }: History): Step[] {
  const steps: Step[] = writes.map((write) => ({ t: write.t, value: write.value, numbers: write.numbers, write }));
  if (initial !== null) {
    steps.push({ t: since ?? steps.at(-1)?.t ?? 0, value: initial, numbers: initialNumbers ?? [], write: undefined });
  }
  return steps.reverse();
}

/** Returns the index of the last step at or before a time; -1 if the first step is later. */
export function stepAt(steps: readonly Step[], t: number): number {
  let [low, high] = [0, steps.length];
  while (low < high) {
    const middle = (low + high) >> 1;
    if ((steps[middle]?.t ?? Infinity) <= t) {
      low = middle + 1;
    } else {
      high = middle;
    }
  }
  return low - 1;
}

/** Formats the line of a write: `start:12`, with the application if it differs from the variable's. */
export function placeOf({ write }: Step, name: string): string {
  if (write === undefined) {
    return "";
  } else if (write.source === null) {
    return write.task === null ? "changed from outside" : "";
  }
  const { application, program, line } = write.source;
  return `${name.startsWith(`${application}:`) || !name.includes(":") ? "" : `${application}:`}${program}:${line}`;
}

/** Formats a time. */
export function timeText(t: number): string {
  return `${t.toFixed(3)} s`;
}
