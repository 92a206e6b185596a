// The widths of columns, from the longest texts. Widths that the browser computes would change while rows scroll by.

import type { GridColumn } from "./columns";
import type { Column, Datum } from "./protocol";
import type { Row } from "./rows";

/** Widths in characters. */
const NARROWEST = 6;
const WIDEST = 36;
const FIXED: Partial<Record<GridColumn["kind"], number>> = { access: 8, container: 10, size: 8, world: 44, reach: 13 };
/** The sign of the order and the space around the text. */
const SPACE = 3;

/** The width of each column in characters. */
export function widthsOf(columns: readonly GridColumn[], rows: readonly Row[]): number[] {
  const values = longestTexts(rows);
  return columns.map((column) => {
    const heading = column.title.length + (column.unit === null ? 0 : column.unit.length + 1);
    return Math.min(WIDEST + 12, Math.max(FIXED[column.kind] ?? 0, heading, longest(column, rows, values)) + SPACE);
  });
}

function longest(column: GridColumn, rows: readonly Row[], values: readonly number[]): number {
  switch (column.kind) {
    case "name": return Math.min(WIDEST, rows.reduce((most, { label, depth }) => Math.max(most, label.length + 2 * depth + 3), 14));
    case "type": return rows.reduce((most, { datum }) => Math.max(most, datum.type.length), 4);
    case "value": return Math.min(WIDEST, Math.max(NARROWEST, values[column.value ?? 0] ?? 0));
    default: return 0;
  }
}

/** By the index of the value: its longest text, with its title if the heading of the table has none. */
function longestTexts(rows: readonly Row[]): number[] {
  const lengths: number[] = [];
  const seen = new Set<Datum>();
  for (const { datum, columns } of rows) {
    if (!seen.has(datum)) {
      seen.add(datum);
      measure(datum, columns, lengths);
    }
  }
  return lengths;
}

function measure({ values }: Datum, columns: readonly Column[], lengths: number[]): void {
  columns.forEach((column, index) => (lengths[index] = Math.max(lengths[index] ?? 0, column.default.length)));
  for (const { texts } of values) {
    texts.forEach((text, index) => (lengths[index] = Math.max(lengths[index] ?? 0, text?.length ?? 0)));
  }
}
