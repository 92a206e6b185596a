// Changes by keyboard, mouse or buttons.

import { contentOf, editOf, isKey, isTyped } from "./cells";
import { merged, pasted, toText } from "./clipboard";
import type { GridColumn } from "./columns";
import type { DataModel } from "./model";
import type { DataEdit } from "./protocol";
import { keyOf, type Row } from "./rows";

/** Begins to edit the active cell. On a cell without editable text, switches the value or access, or expands the row. */
export function enter(model: DataModel, text?: string): void {
  const [row, column] = [model.activeRow(), model.activeColumn()];
  if (row === undefined || column === undefined || refusedAll(model)) {
    return;
  }
  const content = contentOf(row, column);
  if (content.column?.kind === "bool") {
    void setActive(model, text ?? (content.text === "true" ? "false" : "true"));
  } else if (column.kind === "access" && row.kind === "datum") {
    void switchAccess(model);
  } else if (isTyped(row, column) || (column.kind === "name" && isNamed(row))) {
    model.editing.value = { row: row.id, column: column.id, text: text ?? content.text };
  } else if (row.isExpandable) {
    model.toggle(row.id);
  }
}

/** Whether the name of a row can be changed. */
export function isNamed(row: Row): boolean {
  return row.kind === "datum" || isKey(row);
}

/** Sets the text of the active cell. */
async function setActive(model: DataModel, text: string | null): Promise<boolean> {
  const [row, column] = [model.activeRow(), model.activeColumn()];
  return row !== undefined && column !== undefined && (await setCell(model, row, column, text));
}

/** Changes the text of a cell. */
export async function setCell(model: DataModel, row: Row, column: GridColumn, text: string | null): Promise<boolean> {
  const before = contentOf(row, column);
  if (before.text === text) {
    return true;
  }
  if (column.kind === "name" && row.kind === "datum") {
    return model.rename(row.datum.name, text ?? "");
  }
  const edit = editOf(row, column, text);
  if (typeof edit === "string") {
    model.notice.text.value = edit;
    return false;
  }
  return model.edit([edit]);
}

/** Makes the selected data public, or private if the active one is public. */
export async function switchAccess(model: DataModel): Promise<void> {
  const active = model.activeRow();
  if (active !== undefined) {
    const names = namesOf(model.selectedRows());
    await model.edit([{ kind: "access", names, access: active.datum.access === "public" ? "private" : "public" }]);
  }
}

/** Sets the selected values to their defaults. On names, opens the dialog that deletes data or keys. */
export async function clear(model: DataModel): Promise<void> {
  const rectangle = model.rectangle.value;
  if (rectangle === undefined || refusedAll(model)) {
    return;
  }
  const columns = model.columns.value.slice(rectangle.left, rectangle.right + 1);
  if (columns.every(({ kind }) => kind === "name")) {
    await remove(model);
    return;
  }
  const edits = model.selectedRows().flatMap((row) => columns.flatMap((column) => defaultEdit(row, column)));
  await model.edit(merged(edits));
}

function defaultEdit(row: Row, column: GridColumn): DataEdit[] {
  const content = contentOf(row, column);
  const edit = content.column === undefined || content.isDefault ? "" : editOf(row, column, null);
  return typeof edit === "string" ? [] : [edit];
}

/** Deletes the selected keys, or opens the dialog with the uses of the selected data. */
export async function remove(model: DataModel): Promise<void> {
  const rows = model.selectedRows();
  const keys = rows.filter(isKey);
  if (rows.length > 0 && keys.length === rows.length) {
    const containers = new Map(keys.map((row) => [JSON.stringify(row.container), row.container]));
    await model.edit([...containers].map(([id, place]): DataEdit => ({
      kind: "removeKey", place, keys: keys.filter(({ container }) => JSON.stringify(container) === id).flatMap((row) => keyOf(row) ?? []),
    })));
  } else if (namesOf(rows).length > 0 && !refusedAll(model)) {
    model.dialog.value = "delete";
  }
}

/** Returns the names of the data to which rows belong. */
export function namesOf(rows: readonly Row[]): string[] {
  return [...new Set(rows.map(({ container }) => container.name))];
}

export function copied(model: DataModel): string | undefined {
  const { value } = model.rectangle;
  return value && toText(model.rows.value, model.columns.value, value);
}

export async function paste(model: DataModel, text: string): Promise<void> {
  const rectangle = model.rectangle.value;
  if (rectangle === undefined || refusedAll(model)) {
    return;
  }
  const edits = pasted(text, model.rows.value, model.columns.value, rectangle);
  if (typeof edits === "string") {
    model.notice.text.value = edits;
  } else {
    await model.edit(edits);
  }
}

/** Shows the reason if the file cannot be edited, and returns whether there is one. */
function refusedAll(model: DataModel): boolean {
  const reason = model.blocked.value;
  if (reason !== undefined) {
    model.notice.text.value = reason;
  }
  return reason !== undefined;
}
