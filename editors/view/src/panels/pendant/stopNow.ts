// Buttons that stop the arm while the page shows the past.

import type { Cell, Notice } from "../shared/cell";

export const AT_ONCE = "It acts at once, and the page returns to the present.";

/** Returns to the present, whose states the buttons change, and operates the cell. */
export async function pressNow(cell: Cell, notice: Notice, keys: object, text: string): Promise<void> {
  cell.showPresent();
  if (await notice.operate(cell, keys) !== undefined) {
    notice.text.value = `${text} The page shows the present again.`;
  }
}
