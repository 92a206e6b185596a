// Tables after changes. Data and findings that are not replaced stay the same objects.

import type { DataChanges, DataTables, Replacement } from "./protocol";

export function withChanges(tables: DataTables, { version, problem, data, findings }: DataChanges): DataTables {
  return {
    ...tables,
    version,
    problem,
    data: replaced(tables.data, data),
    findings: findings === null ? tables.findings : replaced(tables.findings, findings),
  };
}

function replaced<Item>(list: readonly Item[], { start, deleteCount, items }: Replacement<Item>): readonly Item[] {
  return deleteCount === 0 && items.length === 0 ? list : [...list.slice(0, start), ...items, ...list.slice(start + deleteCount)];
}
