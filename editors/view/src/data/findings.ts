// The findings of the file by the cells that show them.

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

  /** Those of one cell; see `cellId`. */
  of(cell: string): readonly DataFinding[] {
    return this.byCell.get(cell) ?? [];
  }

  /** Those of a datum with all its elements. */
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

/** All messages as one text. */
export function messagesOf(findings: readonly DataFinding[]): string {
  return findings.map(({ message, code }) => (code === "" ? message : `${message} (${code})`)).join(" ");
}
