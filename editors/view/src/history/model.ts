// The shown history, its selected value, and the shown part of the plot.

import { computed, signal } from "@preact/signals";
import { type Range, shifted, zoomed } from "../panels/tasks/range";
import { firstShown, lanesOf } from "./lanes";
import type { FromPage, History, ToPage } from "./messages";
import { type Step, stepsOf } from "./steps";

/** Shortest shown time, in seconds: lines of a program follow within some microseconds. */
const SHORTEST = 1e-6;

export class HistoryModel {
  readonly history = signal<History | undefined>(undefined);
  readonly note = signal<string | null>(null);
  readonly steps = computed(() => (this.history.value === undefined ? [] : stepsOf(this.history.value)));
  /** Index of the selected step. */
  readonly selected = signal(-1);
  /** Indexes of the shown series. */
  readonly shown = signal<ReadonlySet<number>>(new Set());
  readonly lanes = computed(() => lanesOf(this.history.value?.series ?? [], this.shown.value));
  /** Latest present, also if the run has gone back since. */
  private readonly latest = signal(0);
  /** Time from the first step to the latest present. */
  readonly whole = computed((): Range => {
    const start = this.steps.value[0]?.t ?? 0;
    return [start, Math.max(this.latest.value, start + SHORTEST)];
  });
  /** Part that the user has chosen; `undefined` for the whole time. */
  private readonly part = signal<Range | undefined>(undefined);
  readonly range = computed(() => this.part.value ?? this.whole.value);

  constructor(private readonly post: (message: FromPage) => void) {}

  take(message: ToPage): void {
    if (message.kind === "note") {
      this.note.value = message.note;
    } else if (message.kind === "history") {
      this.show(message.history);
    }
  }

  private show(history: History): void {
    const [before, selected] = [this.history.peek(), this.steps.peek()[this.selected.peek()]];
    const wasLast = this.selected.peek() === this.steps.peek().length - 1;
    this.history.value = history;
    this.note.value = null;
    this.latest.value = Math.max(this.latest.peek(), history.now);
    if (JSON.stringify(before?.series) !== JSON.stringify(history.series)) {
      this.shown.value = firstShown(history.type, history.series);
    }
    const steps = this.steps.peek();
    const same = wasLast ? -1 : steps.findIndex((step) => isSame(step, selected));
    this.selected.value = same >= 0 ? same : steps.length - 1;
  }

  /** Selects a step. The plot moves to its time if that is outside the shown part. */
  select(index: number): void {
    const step = this.steps.peek()[index];
    if (step === undefined) {
      return;
    }
    this.selected.value = index;
    const [start, end] = this.range.peek();
    if (step.t < start || step.t > end) {
      const half = (end - start) / 2;
      this.part.value = shifted([step.t - half, step.t + half], 0, this.whole.peek(), SHORTEST);
    }
  }

  /** Shows or hides a series. */
  toggle(series: number): void {
    const shown = new Set(this.shown.peek());
    if (!shown.delete(series)) {
      shown.add(series);
    }
    this.shown.value = shown;
  }

  zoom(factor: number, around: number): void {
    this.showPart(zoomed(this.range.peek(), factor, around, this.whole.peek(), SHORTEST));
  }

  /** Moves the shown part by a fraction, in lengths of the part. */
  shift(part: number, from: Range = this.range.peek()): void {
    this.showPart(shifted(from, part, this.whole.peek(), SHORTEST));
  }

  showAll(): void {
    this.part.value = undefined;
  }

  openLine(index: number, isFinal: boolean): void {
    const source = this.steps.peek()[index]?.write?.source ?? null;
    if (source !== null) {
      this.post({ command: "openLine", source, isFinal });
    }
  }

  /** Requests more writes. */
  showEarlier(): void {
    this.post({ command: "more" });
  }

  private showPart(part: Range): void {
    const [start, end] = this.whole.peek();
    this.part.value = part[0] <= start && part[1] >= end ? undefined : part;
  }
}

function isSame(step: Step, other: Step | undefined): boolean {
  return step.t === other?.t && step.value === other.value && step.write?.source?.line === other.write?.source?.line;
}
