// Rows of the list that shows the recorded writes of a variable.

import type { HistoryBody, WriteLine } from "./requests";

export interface HistoryRow {
  label: string;
  description: string;
  /** Line that the row opens. */
  source?: WriteLine;
  /** Whether the row requests earlier writes. */
  isMore?: boolean;
}

/** Returns the rows: the newest write first, at the end the value before all writes or a row for earlier writes. */
export function historyRows({ writes, initial }: HistoryBody): HistoryRow[] {
  const rows: HistoryRow[] = writes.map(({ t, value, task, source }) => {
    const line = source === null ? "" : `${source.application}:${source.program}() line ${source.line}`;
    const place = [line, task ?? "changed from outside"].filter((part) => part !== "").join(", ");
    return { label: value, description: `${t.toFixed(3)} s, ${place}`, ...(source && { source }) };
  });
  if (initial === null) {
    return [...rows, { label: "Earlier Writes…", description: "", isMore: true }];
  }
  return [...rows, { label: initial, description: writes.length === 0 ? "no write is recorded" : "before these writes" }];
}
