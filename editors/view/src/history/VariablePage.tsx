// Page for a variable: its history, or array elements.

import type { JSX } from "preact";
import { HistoryPage } from "./HistoryPage";
import type { HistoryModel } from "./model";
import type { TableModel } from "./table";
import { TablePage } from "./TablePage";

export function VariablePage({ history, table }: { history: HistoryModel; table: TableModel }): JSX.Element {
  return table.table.value === undefined ? <HistoryPage model={history} /> : <TablePage model={table} table={table.table.value} />;
}
