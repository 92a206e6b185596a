// Space for the rows of a long table that are not in the document.

import type { JSX } from "preact";

export function Spacer({ height, columns }: { height: number; columns: number }): JSX.Element | null {
  return height > 0 ? <tr class="spacer" aria-hidden="true"><td colSpan={columns} style={{ height: `${height}px` }} /></tr> : null;
}
