// Order of a table's data by one column.

import type { GridColumn } from "./columns";
import { contentOf } from "./cells";
import type { DataType, Datum } from "./protocol";
import { type Row, rowsOf } from "./rows";

export interface Order {
  column: string;
  isDescending: boolean;
}

const words = new Intl.Collator("en", { numeric: true });

/** Returns the next order after a click on a column heading: ascending, descending, file order. */
export function nextOrder(order: Order | undefined, column: string): Order | undefined {
  if (order?.column !== column) {
    return { column, isDescending: false };
  }
  return order.isDescending ? undefined : { column, isDescending: true };
}

/** Sorts data. Data without a value in the column, for example arrays, come last. */
export function sorted(data: readonly Datum[], column: GridColumn | undefined, isDescending: boolean, types: ReadonlyMap<string, DataType>): readonly Datum[] {
  if (column === undefined) {
    return data;
  }
  const keys = rowsOf(data, { typeOf: (name) => types.get(name), isExpanded: () => false }).map((row) => ({ datum: row.datum, key: sortKey(row, column) }));
  const sign = isDescending ? -1 : 1;
  keys.sort((left, right) => compare(left.key, right.key, sign));
  return keys.map(({ datum }) => datum);
}

type SortKey = number | string | undefined;

function sortKey(row: Row, column: GridColumn): SortKey {
  if (column.kind === "size") {
    return row.datum.size.reduce((product, length) => product * length, 1);
  }
  const { text, column: value } = contentOf(row, column);
  const number = value?.kind === "number" ? Number(text) : NaN;
  return Number.isFinite(number) ? number : text === "" ? undefined : text;
}

function compare(left: SortKey, right: SortKey, sign: number): number {
  if (left === undefined || right === undefined) {
    return Number(left === undefined) - Number(right === undefined);
  }
  if (typeof left === "number" && typeof right === "number") {
    return sign * (left - right);
  }
  return sign * words.compare(String(left), String(right));
}
