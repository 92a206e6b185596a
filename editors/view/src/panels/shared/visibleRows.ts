// Visible rows of a long table.

/** Number of additional rows above and below, so that scrolling shows no gap. */
const SPARE = 6;

/** The first row is a multiple of this number, so that most movements of the scroll bar draw nothing. */
const STRIDE = 4;

export interface VisibleRows {
  first: number;
  /** Index after the last row. */
  end: number;
}

export function visibleRows(count: number, rowHeight: number, scrollTop: number, height: number): VisibleRows {
  const top = Math.min(Math.floor(scrollTop / rowHeight), count - 1);
  const first = Math.max(0, Math.floor((top - SPARE) / STRIDE) * STRIDE);
  return { first, end: Math.min(count, first + Math.ceil(height / rowHeight) + 2 * SPARE + STRIDE) };
}
