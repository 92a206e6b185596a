// Messages between the page of a variable's history or table and the editor around it. docs/src/debugging.md describes
// both.

import type { HistoryBody, TableBody, WriteLine } from "../debugRequests";

export type { ArrayElement, HistoryBody as History, Series, TableBody as ArrayTable, Write, WriteLine } from "../debugRequests";

export type ToPage =
  | { kind: "history"; history: HistoryBody }
  | { kind: "table"; table: TableBody }
  /** Reason why the shown values are not the present ones; `null` if they are. */
  | { kind: "note"; note: string | null };

export type FromPage =
  | { command: "ready" }
  /** Opens a line; with `isFinal` the editor of the line gets the focus. */
  | { command: "openLine"; source: WriteLine; isFinal: boolean }
  /** Requests more writes or elements. */
  | { command: "more" };
