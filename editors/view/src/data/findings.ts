// Findings in the file by the cells that show them.

import { placeId } from "./place";
import type { DataFinding, DataTables } from "./protocol";

export class Findings {
  private readonly byCell = new Map<string, DataFinding[]>();
  private readonly byName = new Map<string, DataFinding[]>();

  constructor(findings: DataTables["findings"] = []) {
    for (const finding of findings) {
      push(this.byCell, findingCell(finding), finding);
      push(this.byName, finding.place.name, finding);
    }
  }

  /** Returns the findings of a cell; see `cellId`. */
  of(cell: string): readonly DataFinding[] {
    return this.byCell.get(cell) ?? [];
  }

  /** Returns the findings of a datum with all its elements. */
  below(name: string): readonly DataFinding[] {
    return this.byName.get(name) ?? [];
  }
}

function findingCell({ place, column }: DataFinding): string {
  return column === null ? placeId(place) : `${placeId(place)}\u0003${column}`;
}

function push<Key, Value>(map: Map<Key, Value[]>, key: Key, value: Value): void {
  const list = map.get(key);
  if (list === undefined) {
    map.set(key, [value]);
  } else {
    list.push(value);
  }
}

/** Joins all messages. */
export function messagesOf(findings: readonly DataFinding[]): string {
  return findings.map(({ message, code }) => (code === "" ? message : `${message} (${code})`)).join(" ");
}
