// The shown part and series of a plot: a variable over time, or an array over the index.

import { computed, type ReadonlySignal, signal } from "@preact/signals";
import { type Range, shifted, zoomed } from "../panels/tasks/range";
import { lanesOf, type Tick } from "./lanes";
import type { Series } from "./messages";
import { type Step, stepAt } from "./steps";

/** Horizontal axis of a plot. */
export interface PlotAxis {
  /** Shortest shown part. */
  shortest: number;
  /** Whether a value holds until the next one. Other values are points that a line joins. */
  isStepped: boolean;
  /** Returns at most about `count` marks. */
  ticks: (range: Range, count: number) => Tick[];
}

export abstract class PlotModel {
  /** Values in the order of the axis. */
  abstract readonly steps: ReadonlySignal<readonly Step[]>;
  abstract readonly series: ReadonlySignal<readonly Series[]>;
  /** Name of the variable. */
  abstract readonly name: ReadonlySignal<string>;
  /** The entire axis. */
  abstract readonly whole: ReadonlySignal<Range>;
  /** Present time, at which the lines end; `undefined` on other axes. */
  abstract readonly present: ReadonlySignal<number | undefined>;
  abstract readonly axis: PlotAxis;
  /** Help for the keyboard and the mouse. */
  abstract readonly help: string;
  /** Index of the selected step. */
  readonly selected = signal(-1);
  /** Indexes of the shown series. */
  readonly shown = signal<ReadonlySet<number>>(new Set());
  readonly lanes = computed(() => lanesOf(this.series.value, this.shown.value));
  /** Part that the user has chosen; `undefined` for the entire axis. */
  private readonly part = signal<Range | undefined>(undefined);
  readonly range = computed(() => this.part.value ?? this.whole.value);

  /** Describes a step for the hint and for screen readers. */
  abstract describe(step: Step, hasValue: boolean): string;

  /** Opens the origin of a step; `isFinal` gives it the focus. */
  abstract open(index: number, isFinal: boolean): void;

  /** Returns the index of the step at a position of the axis; -1 before the first step. */
  indexAt(position: number): number {
    return stepAt(this.steps.peek(), this.axis.isStepped ? position : position + 0.5);
  }

  /** Selects a step. The plot moves to its position if that is outside the shown part. */
  select(index: number): void {
    const step = this.steps.peek()[index];
    if (step === undefined) {
      return;
    }
    this.selected.value = index;
    const [start, end] = this.range.peek();
    if (step.t < start || step.t > end) {
      const half = (end - start) / 2;
      this.part.value = shifted([step.t - half, step.t + half], 0, this.whole.peek(), this.axis.shortest);
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
    this.showPart(zoomed(this.range.peek(), factor, around, this.whole.peek(), this.axis.shortest));
  }

  /** Moves the shown part by a fraction of its length. */
  shift(part: number, from: Range = this.range.peek()): void {
    this.showPart(shifted(from, part, this.whole.peek(), this.axis.shortest));
  }

  showAll(): void {
    this.part.value = undefined;
  }

  private showPart(part: Range): void {
    const [start, end] = this.whole.peek();
    this.part.value = part[0] <= start && part[1] >= end ? undefined : part;
  }
}
