// Columns of a table: the common ones, then the columns of values.

import type { Column, DataType, Datum } from "./protocol";

export interface GridColumn {
  id: string;
  title: string;
  unit: string | null;
  kind: "name" | "type" | "access" | "container" | "size" | "value" | "world" | "reach";
  /** Whether the cells are numbers, which are aligned to the right. */
  isFigure?: boolean;
  /** Index among the columns of a value. */
  value?: number;
}

const NAME: GridColumn = { id: "#name", title: "Name", unit: null, kind: "name" };
const TYPE: GridColumn = { id: "#type", title: "Type", unit: null, kind: "type" };
const COMMON: readonly GridColumn[] = [
  { id: "#access", title: "Access", unit: null, kind: "access" },
  { id: "#container", title: "Container", unit: null, kind: "container" },
  { id: "#size", title: "Size", unit: null, kind: "size", isFigure: true },
];
const POSE: readonly GridColumn[] = [
  { id: "#world", title: "In world", unit: "x y z rx ry rz", kind: "world" },
  { id: "#reach", title: "Reach", unit: null, kind: "reach" },
];

/** Whether elements of a type have a pose in the cell. */
export function hasPose({ columns }: { columns: readonly Column[] }): boolean {
  return columns.some(({ kind }) => kind === "father");
}

/**
 * Returns the columns of the table for one type, or for all types. Cells in value columns without a title show their
 * own name.
 */
export function gridColumns(shown: DataType | undefined, types: ReadonlyMap<string, DataType>, data: readonly Datum[]): GridColumn[] {
  if (shown !== undefined && shown.fields.length === 0) {
    const values = shown.columns.map(({ id, title, unit, kind }, value): GridColumn => ({ id, title, unit, kind: "value", isFigure: kind === "number", value }));
    return [NAME, ...COMMON, ...values, ...(hasPose(shown) ? POSE : [])];
  }
  const count = widest(shown === undefined ? data.map(({ type }) => type) : [shown.name], types);
  const values = Array.from({ length: count }, (_, value): GridColumn => ({ id: `#${value}`, title: "", unit: null, kind: "value", value }));
  return [NAME, TYPE, ...COMMON, ...values];
}

/** Returns the largest number of columns among these types and their fields' types. */
function widest(names: readonly string[], types: ReadonlyMap<string, DataType>): number {
  const seen = new Set<string>();
  const reach = (name: string): void => {
    if (!seen.has(name)) {
      seen.add(name);
      types.get(name)?.fields.forEach(({ type }) => reach(type));
    }
  };
  names.forEach(reach);
  return Math.max(0, ...[...seen].map((name) => types.get(name)?.columns.length ?? 0));
}
