// The shown history and its selected value.

import { computed, signal } from "@preact/signals";
import { type Range, ticks } from "../panels/tasks/range";
import { firstShown } from "./lanes";
import type { FromPage, History, ToPage } from "./messages";
import { type PlotAxis, PlotModel } from "./plotModel";
import { placeOf, type Step, stepsOf, timeText } from "./steps";

/** Shortest shown time, in seconds: lines of a program follow within some microseconds. */
const SHORTEST = 1e-6;

export class HistoryModel extends PlotModel {
  readonly history = signal<History | undefined>(undefined);
  readonly note = signal<string | null>(null);
  readonly steps = computed(() => (this.history.value === undefined ? [] : stepsOf(this.history.value)));
  readonly series = computed(() => this.history.value?.series ?? []);
  readonly name = computed(() => this.history.value?.name ?? "");
  readonly present = computed(() => this.history.value?.now ?? 0);
  /** Latest present, also if the run has gone back since. */
  private readonly latest = signal(0);
  /** Time from the first step to the latest present. */
  readonly whole = computed((): Range => {
    const start = this.steps.value[0]?.t ?? 0;
    return [start, Math.max(this.latest.value, start + SHORTEST)];
  });
  readonly axis: PlotAxis = {
    shortest: SHORTEST, isStepped: true,
    ticks: (range, count) => ticks(range, count).map((at) => ({ at, text: `${at} s` })),
  };
  readonly help = "Arrow keys select a write, Enter opens its line. Plus and minus or Ctrl and the wheel zoom, drag to move.";

  constructor(private readonly post: (message: FromPage) => void) {
    super();
  }

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

  describe(step: Step, hasValue: boolean): string {
    const place = step.write === undefined ? "before these writes" : placeOf(step, this.name.peek());
    return [hasValue ? step.value : "", timeText(step.t), place].filter((part) => part !== "").join(", ");
  }

  /** Opens the line of a step. */
  open(index: number, isFinal: boolean): void {
    const source = this.steps.peek()[index]?.write?.source ?? null;
    if (source !== null) {
      this.post({ command: "openLine", source, isFinal });
    }
  }

  /** Requests more writes. */
  showEarlier(): void {
    this.post({ command: "more" });
  }
}

function isSame(step: Step, other: Step | undefined): boolean {
  return step.t === other?.t && step.value === other.value && step.write?.source?.line === other.write?.source?.line;
}
