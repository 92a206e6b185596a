// Small tables for tests.

import type { DataTables, DataType, Datum } from "../../src/data/protocol";

const column = (id: string, kind: "number" | "text" | "bool" | "father" = "number", fallback = "0"): DataType["columns"][number] => ({ id, title: id, unit: null, kind, choices: [], default: fallback });

export const TYPES: DataType[] = [
  { name: "num", columns: [column("value")], fields: [], containers: ["array", "collection"] },
  { name: "string", columns: [column("value", "text", "")], fields: [], containers: ["array"] },
  { name: "bool", columns: [column("value", "bool", "false")], fields: [], containers: ["array"] },
  { name: "point", columns: [column("x"), column("y"), column("fatherId", "father", "world[0]")], fields: [], containers: ["array"] },
  { name: "Slot", columns: [], fields: [{ name: "pPick", type: "point", container: "array", size: [1] }, { name: "nTimes", type: "num", container: "array", size: [2] }], containers: ["array"] },
];

export const TYPE_MAP = new Map(TYPES.map((type) => [type.name, type]));

export function datum(name: string, type: string, values: Datum["values"], more: Partial<Datum> = {}): Datum {
  return { name, access: "private", type, container: "array", size: [1], values, ...more };
}

export const DATA = [
  datum("nTen", "num", [{ key: "0", texts: ["10"] }]),
  datum("nTwo", "num", [{ key: "0", texts: ["2"] }], { access: "public" }),
  datum("nGrid", "num", [{ key: "1,0", texts: ["5"] }], { size: [2, 2] }),
  datum("nKeys", "num", [{ key: "a", texts: [null] }, { key: "b", texts: ["7"] }], { container: "collection", size: [2] }),
  datum("pA", "point", [{ key: "0", texts: ["1", null, "fA[0]"] }]),
  datum("tSlot", "Slot", [{ key: "0", texts: [], fields: [datum("pPick", "point", [{ key: "0", texts: ["3", "4", null] }])] }]),
];

export const TABLES: DataTables = { version: 1, dialect: "new", problem: null, types: TYPES, data: DATA, findings: [] };
