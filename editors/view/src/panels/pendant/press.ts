// Presses a key of the pendant.

import type { Cell, Notice } from "../shared/cell";
import type { PendantKey } from "./keyMapping";

export function pressKey(cell: Cell, notice: Notice, key: PendantKey): void {
  void ("page" in key ? notice.send(cell, "userPage", { to: key.page }) : notice.operate(cell, { key: key.code }));
}
