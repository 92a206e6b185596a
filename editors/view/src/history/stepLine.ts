// Step line of a number, reduced to the pixels of the screen.

import { type Step, stepAt } from "./steps";

/** All changes of the number within one pixel of the time axis. */
export interface Column {
  /** Pixel from the left edge of the plot. */
  x: number;
  /** Lowest and highest number within the pixel; `undefined` if there is no number. */
  low: number | undefined;
  high: number | undefined;
  /** Number after the pixel; `undefined` where the line has a gap. */
  last: number | undefined;
}

/** Returns the columns of a series between two times: at most one for each of the `width` pixels. */
export function columnsOf(steps: readonly Step[], series: number, [start, end]: readonly [number, number], width: number): Column[] {
  const scale = width / Math.max(end - start, Number.MIN_VALUE);
  const columns: Column[] = [];
  for (let index = Math.max(0, stepAt(steps, start)); index < steps.length; index += 1) {
    const step = steps[index];
    if (step === undefined || step.t > end) {
      break;
    }
    const x = Math.max(0, Math.min(width, Math.round((step.t - start) * scale)));
    const number = step.numbers[series] ?? undefined;
    const column = columns.at(-1);
    if (column?.x === x) {
      extend(column, number);
    } else {
      columns.push({ x, low: number, high: number, last: number });
    }
  }
  return columns;
}

function extend(column: Column, number: number | undefined): void {
  column.last = number;
  if (number !== undefined) {
    column.low = Math.min(column.low ?? number, number);
    column.high = Math.max(column.high ?? number, number);
  }
}
