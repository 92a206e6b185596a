// Active cell, and the rectangle from an anchor to it.

/** Cell by row id, so that it follows the row when rows are sorted, filtered or changed. */
export interface CellName {
  row: string;
  column: string;
}

export interface Selection {
  active: CellName;
  anchor: CellName;
}

/** Indices; both ends are included. */
export interface Rectangle {
  top: number;
  bottom: number;
  left: number;
  right: number;
}

export interface Position {
  row: number;
  column: number;
}

export interface Extent {
  rows: number;
  columns: number;
  /** Number of visible rows. */
  page: number;
}

/** Returns the cell to which a key moves; undefined if the key does not move. */
export function moved({ row, column }: Position, key: string, isControl: boolean, { rows, columns, page }: Extent): Position | undefined {
  const at = (row: number, column: number): Position => ({ row: clamp(row, rows), column: clamp(column, columns) });
  switch (key) {
    case "ArrowUp": return at(isControl ? 0 : row - 1, column);
    case "ArrowDown": return at(isControl ? rows : row + 1, column);
    case "ArrowLeft": return at(row, isControl ? 0 : column - 1);
    case "ArrowRight": return at(row, isControl ? columns : column + 1);
    case "Home": return at(isControl ? 0 : row, 0);
    case "End": return at(isControl ? rows : row, columns);
    case "PageUp": return at(row - page, column);
    case "PageDown": return at(row + page, column);
    default: return undefined;
  }
}

function clamp(value: number, count: number): number {
  return Math.max(0, Math.min(value, count - 1));
}

export function rectangleOf(active: Position, anchor: Position): Rectangle {
  return {
    top: Math.min(active.row, anchor.row), bottom: Math.max(active.row, anchor.row),
    left: Math.min(active.column, anchor.column), right: Math.max(active.column, anchor.column),
  };
}
