// Lanes of the plot: each unit has its own scale.

import type { Series } from "./messages";
import { ticks } from "../panels/tasks/range";
import { type Step, stepAt } from "./steps";

/** Series with the same unit. */
export interface Lane {
  /** Unit as in the request; `null` for numbers without a unit. */
  unit: string | null;
  isDigital: boolean;
  /** Indexes of the shown series. */
  series: readonly number[];
}

/** Lowest and highest number of a lane. */
export type NumberRange = readonly [low: number, high: number];

const DIGITAL: NumberRange = [-0.25, 1.25];

/** Returns the series that are shown first: all axes of a joint, otherwise all series with the first one's unit. */
export function firstShown(type: string, series: readonly Series[]): ReadonlySet<number> {
  const isShown = ({ unit }: Series): boolean => type === "joint" || unit === series[0]?.unit;
  return new Set(series.flatMap((one, index) => (isShown(one) ? [index] : [])));
}

/** Returns the lanes of the shown series. */
export function lanesOf(series: readonly Series[], shown: ReadonlySet<number>): Lane[] {
  const lanes = new Map<string, { unit: string | null; isDigital: boolean; series: number[] }>();
  series.forEach(({ unit, isDigital }, index) => {
    if (shown.has(index)) {
      const key = JSON.stringify([unit, isDigital]);
      const lane = lanes.get(key) ?? { unit, isDigital, series: [] };
      lane.series.push(index);
      lanes.set(key, lane);
    }
  });
  return [...lanes.values()];
}

/** Returns the range of a lane's numbers between two times, with a margin. */
export function numberRange(lane: Lane, steps: readonly Step[], [start, end]: readonly [number, number]): NumberRange {
  if (lane.isDigital) {
    return DIGITAL;
  }
  let [low, high] = [Infinity, -Infinity];
  for (let index = Math.max(0, stepAt(steps, start)); index < steps.length && (steps[index]?.t ?? Infinity) <= end; index += 1) {
    for (const series of lane.series) {
      const number = steps[index]?.numbers[series];
      if (number !== null && number !== undefined) {
        [low, high] = [Math.min(low, number), Math.max(high, number)];
      }
    }
  }
  if (low > high) {
    return [0, 1];
  }
  // A constant number is drawn in the middle. A margin below the resolution of large numbers would vanish.
  const margin = high > low ? (high - low) * 0.08 : Math.max(1, Math.abs(high) * 0.1);
  return [low - margin, high + margin];
}

/** Axis mark. */
export interface Tick {
  at: number;
  text: string;
}

/** Returns at most about `count` marks of a lane's axis. */
export function numberTicks(lane: Lane, range: NumberRange, count: number): Tick[] {
  if (lane.isDigital) {
    return [{ at: 0, text: "false" }, { at: 1, text: "true" }];
  }
  return ticks(range, count).map((at) => ({ at, text: tickText(at) }));
}

/** Formats a number for an axis briefly: `1.5e9` beyond 7 digits. */
function tickText(number: number): string {
  const size = Math.abs(number);
  return size !== 0 && (size >= 1e7 || size < 1e-4) ? number.toExponential().replace("e+", "e") : String(number);
}

/** Sign of a unit on the screen. */
export function unitSign(unit: string | null): string {
  return unit === null ? "" : unit.replace("degrees", "°");
}
