// Times by program line: the table of `val3 run --times`, with the accuracy of the messages.
//
// Samples contain the arm's times accurate to one cycle, states the tasks' times accurate to 0.1 s.

import type { TaskState } from "./chart";

export interface TimeRow {
  task: string;
  program: string;
  line: number;
  /** Activity: the phase of the move, what the task waits for, or its state. */
  activity: string;
  seconds: number;
}

const NO_MOVE = "no move";
const CYCLE = 0.004;
const WAITING = "waiting";

class Table {
  private readonly rows = new Map<string, TimeRow>();
  private last: TimeRow | undefined;

  add(seconds: number, task: string, program: string, line: number, activity: string): void {
    if (seconds <= 0) {
      return;
    }
    const { last } = this;
    if (last !== undefined && last.line === line && last.activity === activity && last.program === program && last.task === task) {
      last.seconds += seconds;
      return;
    }
    const key = `${task}\n${program}\n${line}\n${activity}`;
    const row = this.rows.get(key) ?? { task, program, line, activity, seconds: 0 };
    row.seconds += seconds;
    this.rows.set(key, row);
    this.last = row;
  }

  copy(): Table {
    const copy = new Table();
    this.rows.forEach((row, key) => copy.rows.set(key, { ...row }));
    return copy;
  }

  sorted(): TimeRow[] {
    return [...this.rows.values()].sort((left, right) => right.seconds - left.seconds
      || left.task.localeCompare(right.task) || left.program.localeCompare(right.program) || left.line - right.line);
  }
}

export interface TimedTasks {
  t: number;
  tasks: readonly TaskState[];
}

/** Returns the times of tasks from the first state up to a time. A task remains in the state of a message until the next message. */
export function taskTimes(states: readonly TimedTasks[], end: number): TimeRow[] {
  const table = new Table();
  states.forEach(({ t, tasks }, index) => {
    const seconds = Math.min(states[index + 1]?.t ?? end, end) - t;
    for (const { name, program, line, state, waits } of tasks) {
      table.add(seconds, name, program, line, waits ?? (state === "running" ? "computing" : state));
    }
  });
  return table.sorted();
}

/** Sample: its time, phase and line. */
export interface TimedPhase {
  t: number;
  phase: string;
  source: { program: string; line: number } | undefined;
}

/** Phases of the arm's samples. */
export interface TimedPhases {
  /** Returns the phases after a time. */
  after: (t: number) => Iterable<TimedPhase>;
  /** Returns a number that changes when phases are discarded. */
  epoch: () => number;
}

/**
 * Counts the times of the arm. A sample is taken at the cycle end; during a gap, the previous sample applies.
 * Only new samples are read, because a run of 40 minutes has 600,000 samples.
 */
export class ArmTimes {
  private table = new Table();
  private last = 0;
  private present: TimedPhase | undefined;
  private epoch: number | undefined;

  constructor(private readonly samples: TimedPhases) {}

  /** Returns the times between two times. */
  between(start: number, end: number): TimeRow[] {
    if (this.epoch !== this.samples.epoch() || end < this.last) {
      this.restart(start);
    }
    for (const sample of this.samples.after(this.last)) {
      if (sample.t > end) {
        break;
      }
      const passed = sample.t - this.last;
      const own = Math.min(passed, CYCLE);
      count(this.table, passed - own, this.present);
      count(this.table, own, sample);
      [this.last, this.present] = [sample.t, sample];
    }
    const table = this.table.copy();
    count(table, end - this.last, this.present);
    return table.sorted();
  }

  private restart(start: number): void {
    this.table = new Table();
    [this.last, this.present, this.epoch] = [start, undefined, this.samples.epoch()];
  }
}

/** Counts seconds in the phase of a sample; without a sample, the time counts as time without a move. */
function count(table: Table, seconds: number, { phase, source }: Partial<TimedPhase> = {}): void {
  const isIdle = phase === undefined || (phase === WAITING && source === undefined);
  const word = isIdle ? NO_MOVE : phase === WAITING ? "waiting for the next move" : phase;
  table.add(seconds, "", isIdle ? "" : (source?.program ?? ""), isIdle ? 0 : (source?.line ?? 0), word);
}

export function share(seconds: number, total: number): string {
  return total > 0 ? `${((seconds / total) * 100).toFixed(1)} %` : "";
}
