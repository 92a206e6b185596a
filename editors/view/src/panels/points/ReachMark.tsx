// Mark of a value that the arm cannot reach.

import type { JSX } from "preact";

export function ReachMark({ reason }: { reason: string | undefined }): JSX.Element | null {
  return reason === undefined ? null : <span class="unreachable" title={reason}> out of reach</span>;
}
