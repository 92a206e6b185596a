// The shown elements of an array or collection, and their plot over the index.

import { computed, signal } from "@preact/signals";
import { type Range, ticks } from "../panels/tasks/range";
import { firstShown, type Tick, unitSign } from "./lanes";
import type { ArrayElement, ArrayTable, FromPage, ToPage } from "./messages";
import { type PlotAxis, PlotModel } from "./plotModel";
import type { Step } from "./steps";

export class TableModel extends PlotModel {
  readonly table = signal<ArrayTable | undefined>(undefined);
  readonly note = signal<string | null>(null);
  /** Elements; `t` is the position in the table. */
  readonly steps = computed((): readonly Step[] => (this.table.value?.rows ?? []).map(({ value, numbers }, t) => ({ t, value, numbers, write: undefined })));
  readonly series = computed(() => this.table.value?.series ?? []);
  readonly name = computed(() => this.table.value?.name ?? "");
  readonly present = computed(() => undefined);
  readonly whole = computed((): Range => [0, Math.max(1, this.steps.value.length - 1)]);
  readonly axis: PlotAxis = { shortest: 2, isStepped: false, ticks: (range, count) => this.indexTicks(range, count) };
  readonly help = "Arrow keys select an element. Plus and minus or Ctrl and the wheel zoom, drag to move.";

  constructor(private readonly post: (message: FromPage) => void) {
    super();
  }

  take(message: ToPage): void {
    if (message.kind === "note") {
      this.note.value = message.note;
    } else if (message.kind === "table") {
      const before = this.table.peek();
      this.table.value = message.table;
      this.note.value = null;
      if (JSON.stringify(before?.series) !== JSON.stringify(message.table.series)) {
        this.shown.value = firstShown(elementType(message.table.type), message.table.series);
      }
    }
  }

  describe(step: Step, hasValue: boolean): string {
    const index = this.table.peek()?.rows[step.t]?.index ?? "";
    return hasValue ? `${index}, ${step.value}` : index;
  }

  /** An element has no line. */
  open(): void {}

  /** Returns the marks at whole positions, with the index or key of their elements. */
  private indexTicks(range: Range, count: number): Tick[] {
    const whole = ticks(range, count).filter((at) => Number.isInteger(at));
    return whole.flatMap((at) => { const text = this.table.peek()?.rows[at]?.index; return text === undefined ? [] : [{ at, text }]; });
  }

  /** Requests more elements. */
  showMore(): void {
    this.post({ command: "more" });
  }
}

/** Returns the type of the elements: `joint` of `joint[3]`. */
function elementType(type: string): string {
  return type.split("[")[0] ?? type;
}

/** Column of the table. */
export interface Column {
  /** Heading: the name of a field with its unit. */
  heading: string;
  text: (row: ArrayElement) => string;
  isNumber: boolean;
}

/** Returns the columns: the index, and the value or each number in it. */
export function columnsOf({ series }: ArrayTable): Column[] {
  const index: Column = { heading: "Index", text: (row) => row.index, isNumber: false };
  const [first] = series;
  if (series.length <= 1) {
    const isNumber = first !== undefined && !first.isDigital;
    return [index, { heading: headingOf("Value", first?.unit ?? null), text: (row) => row.value, isNumber }];
  }
  return [index, ...series.map(({ name, unit }, number): Column => ({
    heading: headingOf(name, unit), text: (row) => numberText(row.numbers[number] ?? null), isNumber: true,
  }))];
}

function headingOf(name: string, unit: string | null): string {
  return unit === null ? name : `${name} (${unitSign(unit)})`;
}

/** Formats a number with at most 10 digits. */
function numberText(number: number | null): string {
  return number === null ? "not finite" : String(Number(number.toPrecision(10)));
}
