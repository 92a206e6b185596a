// States of tasks and moves of the arm as segments of time.

import type * as wire from "../../wire";

/** State of a task. Runs of earlier versions have no `awaits`, `callers` and `lineCode`. */
export type TaskState = Omit<wire.TaskState, "awaits" | "callers" | "lineCode"> & { callers?: readonly wire.CallingLine[] | undefined } & { [Key in "awaits" | "lineCode"]?: string | null | undefined };

/** Time span in which a task is in one state. */
export interface Segment {
  start: number;
  end: number;
  state: string;
  waits: string | null;
  program: string;
  line: number;
  file: string;
}

/** Segments of all tasks, by task name. They grow with each added state. */
export class TaskSegments {
  private readonly lanes = new Map<string, Segment[]>();

  /** Adds the states of all tasks from `t` on. Missing tasks have ended. */
  add(t: number, tasks: readonly TaskState[]): void {
    const present = new Set(tasks.map(({ name }) => name));
    for (const [name, lane] of this.lanes) {
      const open = lane.at(-1);
      if (!present.has(name) && open !== undefined && open.end === Infinity) {
        open.end = t;
      }
    }
    for (const task of tasks) {
      this.extend(t, task);
    }
  }

  clear(): void {
    this.lanes.clear();
  }

  names(): string[] {
    return [...this.lanes.keys()];
  }

  of(name: string): readonly Segment[] {
    return this.lanes.get(name) ?? [];
  }

  private extend(t: number, { name, state, waits, program, line, file }: TaskState): void {
    const lane = this.lanes.get(name) ?? [];
    this.lanes.set(name, lane);
    const open = lane.at(-1);
    const isSame = open?.end === Infinity && open.state === state && open.waits === waits
      && (waits === null || (open.program === program && open.line === line));
    if (isSame) {
      return;
    }
    if (open?.end === Infinity) {
      open.end = t;
    }
    lane.push({ start: t, end: Infinity, state, waits, program, line, file });
  }
}

/** Returns the visible segments between two times, in pixels. Segments too short to be visible are joined. */
export function visible(segments: readonly Segment[], start: number, end: number, width: number): (Segment & { x: number; w: number })[] {
  const scale = width / Math.max(end - start, 1e-9);
  const shown: (Segment & { x: number; w: number })[] = [];
  for (const segment of segments) {
    if (segment.end <= start || segment.start >= end) {
      continue;
    }
    const x = Math.max(0, (segment.start - start) * scale);
    const w = Math.min(width, (segment.end - start) * scale) - x;
    const last = shown.at(-1);
    if (last !== undefined && w < 0.5 && x < last.x + last.w + 0.5) {
      last.w = Math.max(last.w, x + w - last.x);
      continue;
    }
    shown.push({ ...segment, x, w });
  }
  return shown;
}

/** Whether the wait is for the arm. The chart connects such a wait with the move that ended it. */
export function awaitsArm({ waits }: { waits: string | null }): boolean {
  return waits !== null && /\bthe arm\b/.test(waits);
}

export interface WaitTotal {
  task: string;
  waits: string;
  program: string;
  line: number;
  file: string;
  seconds: number;
  count: number;
}

/** Returns the waits between two times, the longest first: the chart as a table. */
export function waitTotals(segments: TaskSegments, start: number, end: number): WaitTotal[] {
  const totals = new Map<string, WaitTotal>();
  for (const task of segments.names()) {
    for (const { waits, program, line, file, ...segment } of segments.of(task)) {
      const seconds = Math.min(segment.end, end) - Math.max(segment.start, start);
      if (waits === null || seconds <= 0) {
        continue;
      }
      const key = JSON.stringify([task, waits, file, program, line]);
      const total = totals.get(key) ?? { task, waits, program, line, file, seconds: 0, count: 0 };
      totals.set(key, { ...total, seconds: total.seconds + seconds, count: total.count + 1 });
    }
  }
  return [...totals.values()].sort((left, right) => right.seconds - left.seconds);
}
