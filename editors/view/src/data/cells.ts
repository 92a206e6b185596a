// Content of cells, and the edits that change it.

import type { GridColumn } from "./columns";
import { placeId } from "./place";
import type { Access, Column, DataEdit } from "./protocol";
import { isScalar, keyOf, type Row } from "./rows";

/** Cell content. */
export interface CellContent {
  text: string;
  /** Whether the file does not contain the value. */
  isDefault: boolean;
  /** Column of the value, if the cell shows one. */
  column?: Column;
}

const EMPTY: CellContent = { text: "", isDefault: false };

export function contentOf(row: Row, column: GridColumn): CellContent {
  const { datum, element, kind } = row;
  const isContainer = kind !== "element";
  switch (column.kind) {
    case "name": return { text: row.label, isDefault: false };
    case "type": return isContainer ? { text: datum.type, isDefault: false } : EMPTY;
    // Only fields have no access.
    case "access": return kind === "datum" ? { text: datum.access as Access, isDefault: false } : EMPTY;
    case "container": return isContainer ? { text: datum.container, isDefault: isScalar(datum) } : EMPTY;
    case "size": return isContainer ? { text: sizeText(row), isDefault: isScalar(datum) } : EMPTY;
    case "value": return element === undefined ? EMPTY : valueContent(row, column.value ?? 0);
    case "world":
    case "reach": return EMPTY;
  }
}

function sizeText({ datum: { container, size } }: Row): string {
  const [keys = 0] = size;
  return container === "collection" ? `${keys} ${keys === 1 ? "key" : "keys"}` : size.join(" ");
}

function valueContent({ columns, value }: Row, index: number): CellContent {
  const column = columns[index];
  if (column === undefined) {
    return EMPTY;
  }
  const text = value?.texts[index] ?? null;
  return { text: text ?? column.default, isDefault: text === null, column };
}

/** Whether typing changes a cell. Names are changed by a rename, access by a switch. */
export function isTyped(row: Row, column: GridColumn): boolean {
  return (column.kind === "value" && contentOf(row, column).column !== undefined) || (column.kind === "size" && isResizable(row));
}

export function isResizable({ kind, datum }: Row): boolean {
  return kind !== "element" && datum.container === "array";
}

export function isKey(row: Row): boolean {
  return row.kind === "element" && row.datum.container === "collection";
}

/**
 * Returns the edit that changes the text of a cell; null sets the default. Returns a sentence if the edit is not
 * possible.
 */
export function editOf(row: Row, column: GridColumn, text: string | null): DataEdit | string {
  const { datum, element, container } = row;
  const value = contentOf(row, column).column;
  if (value !== undefined && element !== undefined) {
    return { kind: "set", cells: [{ place: element, column: value.id, text }] };
  } else if (column.kind === "size" && isResizable(row)) {
    const size = sizeFrom(text ?? "1");
    return size === undefined ? `A size is up to three whole numbers, such as "10" or "3 4", not "${text ?? ""}".` : { kind: "resize", place: container, size };
  } else if (column.kind === "name" && isKey(row)) {
    return { kind: "renameKey", place: container, key: keyOf(row) ?? "", as: text ?? "" };
  } else if (column.kind === "access" && row.kind === "datum" && (text === "public" || text === "private")) {
    return { kind: "access", names: [datum.name], access: text };
  }
  return `${column.title || "The cell"} of ${datum.name} is not changed by a text.`;
}

/** Parses the dimensions in a text. The server checks the limits. */
export function sizeFrom(text: string): number[] | undefined {
  const size = text.trim().split(/[\s,]+/).map(Number);
  return size.length <= 3 && size.every((length) => Number.isInteger(length) && length > 0) ? size : undefined;
}

/** Returns the id of a cell among the findings. */
export function cellId(row: Row, column: GridColumn): string {
  const value = contentOf(row, column).column;
  return value === undefined ? placeId(row.container) : `${placeId(row.element ?? row.container)}\u0003${value.id}`;
}
