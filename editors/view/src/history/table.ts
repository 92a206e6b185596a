// Shown array or collection elements.

import { signal } from "@preact/signals";
import { unitSign } from "./lanes";
import type { ArrayElement, ArrayTable, FromPage, ToPage } from "./messages";

export class TableModel {
  readonly table = signal<ArrayTable | undefined>(undefined);
  readonly note = signal<string | null>(null);

  constructor(private readonly post: (message: FromPage) => void) {}

  take(message: ToPage): void {
    if (message.kind === "note") {
      this.note.value = message.note;
    } else if (message.kind === "table") {
      this.table.value = message.table;
      this.note.value = null;
    }
  }

  /** Requests more elements. */
  showMore(): void {
    this.post({ command: "more" });
  }
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
