// Time range that the chart shows.

export type Range = readonly [start: number, end: number];

const SHORTEST = 0.05;

/**
 * Zooms into the range by a factor below 1, or out of it, around a time that keeps its location on the screen. The range
 * does not become shorter than `shortest`.
 */
export function zoomed([start, end]: Range, factor: number, around: number, whole: Range, shortest = SHORTEST): Range {
  const length = Math.min(Math.max((end - start) * factor, shortest), Math.max(whole[1] - whole[0], shortest));
  const place = end > start ? (around - start) / (end - start) : 0.5;
  return inside([around - place * length, around + (1 - place) * length], whole, shortest);
}

/** Moves the range by a fraction, in lengths of the range. */
export function shifted([start, end]: Range, part: number, whole: Range, shortest = SHORTEST): Range {
  const way = (end - start) * part;
  return inside([start + way, end + way], whole, shortest);
}

function inside([start, end]: Range, whole: Range, shortest: number): Range {
  const back = Math.max(0, end - Math.max(whole[1], whole[0] + shortest));
  const first = Math.max(whole[0], start - back);
  return [first, first + (end - start)];
}

/** Returns at most `count` times with round distances for the axis. */
export function ticks([start, end]: Range, count: number): number[] {
  const rough = (end - start) / Math.max(1, count);
  const power = 10 ** Math.floor(Math.log10(rough));
  const distance = [1, 2, 5, 10].map((factor) => factor * power).find((size) => size >= rough) ?? 10 * power;
  const first = Math.ceil(start / distance);
  return Array.from({ length: Math.max(0, Math.floor(end / distance) - first + 1) }, (_, at) => Number(((first + at) * distance).toPrecision(12)));
}
