// Column widths from the longest texts. Widths computed by the browser would change during scrolling.

import type { GridColumn } from "./columns";
import type { Column, Datum } from "./protocol";
import type { Row } from "./rows";

/** Widths in characters. */
const NARROWEST = 6;
const WIDEST = 36;
/** Largest width for a text that is the only value of a row. */
const WIDEST_TEXT = 64;
const FIXED: Partial<Record<GridColumn["kind"], number>> = { access: 8, container: 10, size: 8, world: 44, reach: 13 };
/** Width of the sort indicator and the space around the text. */
const SPACE = 3;

/** Returns the column widths in characters. */
export function widthsOf(columns: readonly GridColumn[], rows: readonly Row[]): number[] {
  const values = longestTexts(rows, columns.every(({ kind, title }) => kind !== "value" || title !== ""));
  const widest = columns.filter(({ kind }) => kind === "value").length === 1 ? WIDEST_TEXT : WIDEST;
  return columns.map((column) => {
    const heading = column.title.length + (column.unit === null ? 0 : column.unit.length + 1);
    return Math.max(FIXED[column.kind] ?? 0, heading, longest(column, rows, values, widest)) + SPACE;
  });
}

function longest(column: GridColumn, rows: readonly Row[], values: readonly number[], widest: number): number {
  switch (column.kind) {
    case "name": return Math.min(WIDEST, rows.reduce((most, { label, depth }) => Math.max(most, label.length + 2 * depth + 3), 14));
    case "type": return rows.reduce((most, { datum }) => Math.max(most, datum.type.length), 4);
    case "value": return Math.min(widest, Math.max(NARROWEST, values[column.value ?? 0] ?? 0));
    default: return 0;
  }
}

/** Returns the longest text by the index of the value, with title and unit for cells that show their own name. */
function longestTexts(rows: readonly Row[], hasTitles: boolean): number[] {
  const lengths: number[] = [];
  const seen = new Set<Datum>();
  for (const { datum, columns } of rows) {
    if (!seen.has(datum)) {
      seen.add(datum);
      columns.forEach((column, index) => {
        const around = hasTitles ? 0 : column.title.length + (column.unit?.length ?? 0) + 2;
        lengths[index] = Math.max(lengths[index] ?? 0, around + longestText(datum, column, index));
      });
    }
  }
  return lengths;
}

function longestText({ values }: Datum, column: Column, index: number): number {
  return values.reduce((most, { texts }) => Math.max(most, texts[index]?.length ?? 0), column.default.length);
}
