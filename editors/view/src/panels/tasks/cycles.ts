// Cycle times: the periods of a move or a signal, as in `val3 run --cycles`, with the accuracy of the messages.

import { ARM, importanceOf, TIME } from "../../status/waits";
import type { SignalInfo } from "../io/signalRows";
import type { SignalHistory } from "../io/sparkline";
import type { Segment } from "./chart";
import type { RunEvent } from "./eventText";
import type { MoveTimes } from "./moves";

/** Event that repeats, and its times in s. */
export interface RepeatedEvent {
  name: string;
  times: readonly number[];
}

/** Parts of a cycle in s: the motion of the arm, and while it rests, the waits of the task that moves it. */
export interface CycleParts {
  moving: number;
  outside: number;
  arm: number;
  time: number;
  other: number;
}

export interface CycleRow extends CycleParts {
  from: number;
  to: number;
}

/** Time span. */
interface Span {
  start: number;
  end: number;
}

/** Parts of a cycle with their names in tables. */
export const PARTS: readonly (readonly [keyof CycleParts, string])[] = [
  ["moving", "Arm moves"], ["outside", "Waits for a condition or signal"], ["arm", "Waits for the arm"], ["time", "Waits for time"], ["other", "Other"],
];

/** Returns the moves and digital signals that repeat up to a time, in the order of their first occurrence. */
export function repeatedEvents(moves: readonly MoveTimes[], signals: readonly Pick<SignalInfo, "link" | "isDigital">[], history: Pick<SignalHistory, "of">, until: number): RepeatedEvent[] {
  const times = new Map<string, number[]>();
  const add = (name: string, t: number): void => {
    if (t <= until) {
      times.set(name, [...(times.get(name) ?? []), t]);
    }
  };
  for (const { program, line, started } of moves) {
    if (started !== undefined && program !== "") {
      add(`Move in ${program}:${line}`, started);
    }
  }
  for (const { link, isDigital } of signals) {
    for (const [index, [t, value]] of history.of(link).entries()) {
      // The first value is no change.
      if (isDigital && index > 0 && value !== 0) {
        add(`${link} becomes true`, t);
      }
    }
  }
  const repeated = [...times].filter(([, { length }]) => length > 1).map(([name, own]) => ({ name, times: own }));
  return repeated.sort((left, right) => (left.times[0] ?? 0) - (right.times[0] ?? 0));
}

/** Returns the name of the task that has recorded the last move. */
export function moverOf(events: readonly RunEvent[]): string | undefined {
  const recorded = events.findLast((event) => event.kind === "move" && event["phase"] === "recorded" && event["task"] !== undefined);
  return recorded && String(recorded["task"]);
}

/** Returns the cycles between successive times. `rests` are those of the arm, `waits` the segments of the task that moves it. */
export function cyclesOf(times: readonly number[], rests: readonly Span[], waits: readonly Segment[]): CycleRow[] {
  return times.slice(1).map((to, index) => {
    const row: CycleRow = { from: times[index] ?? to, to, moving: 0, outside: 0, arm: 0, time: 0, other: 0 };
    let resting = 0;
    for (const rest of overlaps(rests, row.from, to)) {
      resting += rest.end - rest.start;
      for (const wait of overlaps(waits, rest.start, rest.end)) {
        row[partOf(wait)] += wait.end - wait.start;
      }
    }
    row.moving = to - row.from - resting;
    row.other += resting - (row.outside + row.arm + row.time + row.other);
    return row;
  });
}

function partOf({ waits }: Segment): keyof CycleParts {
  if (waits === null) {
    return "other";
  }
  if (/^(?:a condition|the power) of the arm\b/.test(waits)) {
    return "arm";
  }
  switch (importanceOf(waits)) {
    case ARM: return "arm";
    case TIME: return "time";
    default: return "outside";
  }
}

/** Returns the parts of chronological spans between two times. */
function overlaps<Item extends Span>(spans: readonly Item[], from: number, to: number): Item[] {
  let [low, high] = [0, spans.length];
  while (low < high) {
    const middle = (low + high) >> 1;
    if ((spans[middle]?.end ?? Infinity) <= from) {
      low = middle + 1;
    } else {
      high = middle;
    }
  }
  const found: Item[] = [];
  for (let index = low; (spans[index]?.start ?? Infinity) < to; index += 1) {
    const span = spans[index] as Item;
    found.push({ ...span, start: Math.max(span.start, from), end: Math.min(span.end, to) });
  }
  return found;
}

export interface CycleSummary extends CycleParts {
  count: number;
  first: number;
  min: number;
  mean: number;
  max: number;
}

/** Returns the times over all cycles; `undefined` without a cycle. */
export function summaryOf(cycles: readonly CycleRow[]): CycleSummary | undefined {
  const seconds = cycles.map(({ from, to }) => to - from);
  const [first] = seconds;
  if (first === undefined) {
    return undefined;
  }
  const mean = (values: readonly number[]): number => values.reduce((sum, value) => sum + value, 0) / values.length;
  const part = (name: keyof CycleParts): number => mean(cycles.map((cycle) => cycle[name]));
  return {
    count: seconds.length, first, min: Math.min(...seconds), mean: mean(seconds), max: Math.max(...seconds),
    moving: part("moving"), outside: part("outside"), arm: part("arm"), time: part("time"), other: part("other"),
  };
}
