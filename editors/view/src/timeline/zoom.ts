// Time range that the time bar shows. It follows the shown time.

import { computed, type ReadonlySignal, signal } from "@preact/signals";
import { type Range, shifted, zoomed } from "../panels/tasks/range";

export class TimeZoom {
  /** Shown range; the entire time without a zoom. */
  readonly range: ReadonlySignal<Range>;
  readonly isZoomed: ReadonlySignal<boolean>;
  private readonly chosen = signal<Range | undefined>(undefined);

  constructor(private readonly whole: ReadonlySignal<Range>, time: ReadonlySignal<number>) {
    this.isZoomed = computed(() => this.chosen.value !== undefined);
    this.range = computed(() => (this.chosen.value === undefined ? whole.value : containing(this.chosen.value, time.value, whole.value)));
  }

  /** Zooms in with a factor below 1, or out of the range, around a time. */
  zoom(factor: number, around: number): void {
    const whole = this.whole.peek();
    const [start, end] = zoomed(this.range.peek(), factor, around, whole);
    this.chosen.value = start <= whole[0] && end >= whole[1] ? undefined : [start, end];
  }

  /** Moves the range by a fraction, in lengths of the range. */
  shift(part: number): void {
    if (this.chosen.peek() !== undefined) {
      this.chosen.value = shifted(this.range.peek(), part, this.whole.peek());
    }
  }

  reset(): void {
    this.chosen.value = undefined;
  }
}

/** Returns the range, or one of the same length that contains the time. */
export function containing([start, end]: Range, t: number, whole: Range): Range {
  if (t >= start && t <= end) {
    return [start, end];
  }
  const length = end - start;
  // When the time leaves the range forwards, the new range begins shortly before it, so that the following events are visible.
  const last = Math.min(t > end ? t + length * 0.1 : t + length, Math.max(whole[1], whole[0] + length));
  return [last - length, last];
}
