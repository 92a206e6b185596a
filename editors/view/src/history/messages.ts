// Messages between the page of a variable's history and the editor around it. docs/src/debugging.md describes the
// history.

import type { HistoryBody, WriteLine } from "../debugRequests";

export type { HistoryBody as History, Series, Write, WriteLine } from "../debugRequests";

export type ToPage =
  | { kind: "history"; history: HistoryBody }
  /** Reason why the shown history is not the present one; `null` if it is. */
  | { kind: "note"; note: string | null };

export type FromPage =
  | { command: "ready" }
  /** Opens a line; with `isFinal` the editor of the line gets the focus. */
  | { command: "openLine"; source: WriteLine; isFinal: boolean }
  /** Requests more writes. */
  | { command: "earlier" };
