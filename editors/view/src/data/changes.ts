// Applies changes to tables. Data and findings that are not replaced remain the same objects.

import type { DataChanges, DataTables, Datum, Replacement } from "./protocol";

export function withChanges(tables: DataTables, { version, problem, data, values, findings }: DataChanges): DataTables {
  const complete = values === null ? data : { ...data, items: data.items.map((datum) => withValues(datum, tables.data[data.start], values)) };
  return {
    ...tables,
    version,
    problem,
    data: replaced(tables.data, complete),
    findings: findings === null ? tables.findings : replaced(tables.findings, findings),
  };
}

/** Returns a datum with its previous values, some of which are replaced. */
function withValues(datum: Datum, before: Datum | undefined, { start, deleteCount }: { start: number; deleteCount: number }): Datum {
  return { ...datum, values: replaced(before?.values ?? [], { start, deleteCount, items: datum.values }) };
}

function replaced<Item>(list: readonly Item[], { start, deleteCount, items }: Replacement<Item>): readonly Item[] {
  return deleteCount === 0 && items.length === 0 ? list : [...list.slice(0, start), ...items, ...list.slice(start + deleteCount)];
}
