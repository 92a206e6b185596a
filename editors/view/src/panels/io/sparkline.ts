// Values of a signal over the last seconds as the path of a small drawing.

/** Change of a value at a time. */
export type Change = readonly [t: number, value: number];

export const WIDTH = 96;
export const HEIGHT = 18;
/** Seconds that a sparkline shows. */
export const SPAN = 10;

/** Changes of all signals, in chronological order. */
export class SignalHistory {
  private readonly changes = new Map<string, Change[]>();

  add(link: string, t: number, value: number): void {
    const own = this.changes.get(link);
    if (own === undefined) {
      this.changes.set(link, [[t, value]]);
    } else if (own.at(-1)?.[1] !== value) {
      own.push([t, value]);
    }
  }

  clear(): void {
    this.changes.clear();
  }

  of(link: string): readonly Change[] {
    return this.changes.get(link) ?? [];
  }
}

/** Returns the changes that determine a time window: the last one before its start, and all within it. */
export function within(changes: readonly Change[], start: number, end: number): readonly Change[] {
  return changes.slice(Math.max(0, firstAfter(changes, start) - 1), firstAfter(changes, end));
}

/** Returns steps from value to value, up to the time `end`. A constant value is a horizontal line. */
export function sparkPath(changes: readonly Change[], end: number, isDigital: boolean): string {
  const start = end - SPAN;
  const shown = within(changes, start, end);
  const values = shown.map(([, value]) => value);
  const [low, high] = isDigital ? [0, 1] : [Math.min(...values), Math.max(...values)];
  const y = (value: number): string => (HEIGHT - 3 - (high > low ? (value - low) / (high - low) : 0.5) * (HEIGHT - 6)).toFixed(1);
  const x = (t: number): string => (Math.max(0, (t - start) / SPAN) * WIDTH).toFixed(1);
  return shown.map(([t, value], at) => (at === 0 ? `M${x(t)} ${y(value)}` : `H${x(t)}V${y(value)}`)).join("") + (shown.length > 0 ? `H${WIDTH}` : "");
}

/** Returns the index of the first change after a time. */
function firstAfter(changes: readonly Change[], t: number): number {
  let [low, high] = [0, changes.length];
  while (low < high) {
    const middle = (low + high) >> 1;
    if ((changes[middle]?.[0] ?? Infinity) <= t) {
      low = middle + 1;
    } else {
      high = middle;
    }
  }
  return low;
}
