// Rectangles of cells as text, in the format of spreadsheets: tabs between cells, line ends between rows.

import { contentOf, editOf, isTyped } from "./cells";
import type { GridColumn } from "./columns";
import type { CellChange, Column, DataEdit } from "./protocol";
import type { Rectangle } from "./selection";
import type { Row } from "./rows";

export function toText(rows: readonly Row[], columns: readonly GridColumn[], { top, bottom, left, right }: Rectangle): string {
  const line = (row: Row): string => columns.slice(left, right + 1).map((column) => quoted(contentOf(row, column).text)).join("\t");
  return rows.slice(top, bottom + 1).map(line).join("\n");
}

function quoted(text: string): string {
  return /[\t\n\r"]/.test(text) ? `"${text.replaceAll("\"", "\"\"")}"` : text;
}

/** Splits a text from a spreadsheet into cells. A line end after the last row is not a row. */
export function fromText(text: string): string[][] {
  const rows: string[][] = [[]];
  for (const [, cell = "", end = ""] of text.matchAll(/("(?:[^"]|"")*"(?=[\t\r\n]|$)|[^\t\r\n]*)(\t|\r\n|\r|\n|$)/g)) {
    const row = rows.at(-1);
    row?.push(/^".*"$/s.test(cell) ? cell.slice(1, -1).replaceAll("\"\"", "\"") : cell);
    if (end === "") {
      break;
    }
    if (end !== "\t") {
      rows.push([]);
    }
  }
  const last = rows.at(-1);
  return rows.length > 1 && last?.length === 1 && last[0] === "" ? rows.slice(0, -1) : rows;
}

/**
 * Returns the edits that write spreadsheet cells, starting at the upper left corner of a rectangle. A single cell fills
 * the rectangle. Unchanged cells are omitted. Returns a sentence if a cell cannot be written.
 */
export function pasted(text: string, rows: readonly Row[], columns: readonly GridColumn[], target: Rectangle): DataEdit[] | string {
  const cells = fromText(text);
  const isSingle = cells.length === 1 && cells[0]?.length === 1;
  const height = isSingle ? target.bottom - target.top + 1 : cells.length;
  const width = isSingle ? target.right - target.left + 1 : Math.max(...cells.map((row) => row.length));
  if (target.top + height > rows.length || target.left + width > columns.length) {
    return `The clipboard has ${height} rows and ${width} columns. From the selected cell on there are only ${rows.length - target.top} and ${columns.length - target.left}.`;
  }
  const edits: DataEdit[] = [];
  for (const [down, row] of rows.slice(target.top, target.top + height).entries()) {
    for (const [across, column] of columns.slice(target.left, target.left + width).entries()) {
      const edit = cellEdit(row, column, cells[isSingle ? 0 : down]?.[isSingle ? 0 : across]);
      if (typeof edit === "string") {
        return edit;
      }
      edits.push(...edit);
    }
  }
  return merged(edits);
}

function cellEdit(row: Row, column: GridColumn, text: string | undefined): DataEdit[] | string {
  const { text: before, column: value } = contentOf(row, column);
  const now = value === undefined ? text?.trim() : text && plain(text, value);
  if (now === undefined || now === before) {
    return [];
  }
  if (!isTyped(row, column) && column.kind !== "access") {
    return `${column.title || "This cell"} of ${row.label} cannot be pasted: it is "${before}", and the clipboard has "${now}". Select the cells of values.`;
  }
  const edit = editOf(row, column, now === "" && value?.kind !== "text" ? null : now);
  return typeof edit === "string" ? edit : [edit];
}

/**
 * Converts spreadsheet text to the format of data files: a decimal comma and the capitals of truth values depend on the
 * language.
 */
export function plain(text: string, { kind }: Column): string {
  const trimmed = text.trim();
  switch (kind) {
    case "number": return /^[-+]?\d*,\d+(?:e[-+]?\d+)?$/i.test(trimmed) ? trimmed.replace(",", ".") : trimmed;
    case "bool": return /^(?:true|1)$/i.test(trimmed) ? "true" : /^(?:false|0)$/i.test(trimmed) ? "false" : trimmed;
    case "text": return text;
    default: return trimmed;
  }
}

/** Merges all changes of values into one edit. */
export function merged(edits: readonly DataEdit[]): DataEdit[] {
  const cells: CellChange[] = edits.flatMap((edit) => (edit.kind === "set" ? edit.cells : []));
  const others = edits.filter(({ kind }) => kind !== "set");
  return cells.length === 0 ? others : [...others, { kind: "set", cells }];
}
