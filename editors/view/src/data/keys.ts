// Keyboard control of the table.

import { clear, enter } from "./actions";
import { contentOf, isTyped } from "./cells";
import type { DataModel } from "./model";
import { moved } from "./selection";

/**
 * Handles a key of the table outside fields, and returns whether it was handled. `page` is the number of visible rows.
 */
export function pressed(model: DataModel, event: KeyboardEvent, page: number): boolean {
  const isControl = event.ctrlKey || event.metaKey;
  if (event.altKey) {
    return false;
  }
  if (isControl && event.key.toLowerCase() === "a") {
    selectAll(model);
    return true;
  }
  return move(model, event, page) || (!isControl && act(model, event));
}

function selectAll(model: DataModel): void {
  const [first, last] = [model.rows.value[0], model.rows.value.at(-1)];
  const [left, right] = [model.columns.value[0], model.columns.value.at(-1)];
  if (first !== undefined && last !== undefined && left !== undefined && right !== undefined) {
    model.selection.value = { anchor: { row: last.id, column: right.id }, active: { row: first.id, column: left.id } };
  }
}

function move(model: DataModel, { key, ctrlKey, metaKey, shiftKey }: KeyboardEvent, page: number): boolean {
  const { value: selection } = model.selection;
  const from = (selection && model.positionOf(selection.active)) ?? { row: 0, column: 0 };
  const to = moved(from, key, ctrlKey || metaKey, { rows: model.rows.value.length, columns: model.columns.value.length, page });
  if (to !== undefined) {
    model.select(to.row, to.column, shiftKey);
  }
  return to !== undefined;
}

function act(model: DataModel, { key }: KeyboardEvent): boolean {
  const [row, column] = [model.activeRow(), model.activeColumn()];
  if (row === undefined || column === undefined) {
    return false;
  }
  switch (key) {
    case "Enter":
    case "F2":
      enter(model);
      return true;
    case "Delete":
    case "Backspace":
      void clear(model);
      return true;
    case "Insert":
      if (model.blocked.value === undefined) {
        model.dialog.value = row.datum.container === "collection" ? "addKey" : "add";
      }
      return true;
    case " ": {
      const isSwitched = contentOf(row, column).column?.kind === "bool" || column.kind === "access";
      if (!isSwitched && row.isExpandable) {
        model.toggle(row.id);
      } else if (isSwitched || isTyped(row, column)) {
        enter(model, isSwitched ? undefined : key);
      }
      return true;
    }
    default:
      // Typing replaces the text of a cell.
      if (key.length === 1 && isTyped(row, column) && contentOf(row, column).column?.kind !== "bool") {
        enter(model, key);
        return true;
      }
      return false;
  }
}
