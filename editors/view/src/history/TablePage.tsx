// Page with array or collection elements. Only the visible rows are in the document.

import type { JSX } from "preact";
import { useEffect } from "preact/hooks";
import { Spacer } from "../panels/shared/Spacer";
import { useVisibleRows } from "../panels/shared/useVisibleRows";
import type { ArrayTable } from "./messages";
import { PlotSection } from "./PlotSection";
import { revealRow } from "./revealRow";
import { timeText } from "./steps";
import { columnsOf, type TableModel } from "./table";

/** Height of a row in px, as in history.css. */
const ROW = 24;

export function TablePage({ model, table }: { model: TableModel; table: ArrayTable }): JSX.Element {
  const note = model.note.value;
  return (
    <main class="history table">
      <header>
        <h1>{table.name}</h1>
        <span class="muted">{table.type}</span>
        <span class="muted">{countText(table)}</span>
        <span class="present">present: {timeText(table.now)}</span>
      </header>
      {note === null ? null : <p class="note" role="status">{note}</p>}
      {table.series.length === 0 ? <Elements model={model} table={table} /> : (
        <div class="parts">
          <Elements model={model} table={table} />
          <PlotSection model={model} shownPart="elements" earlier="Lower indexes" later="Higher indexes" />
        </div>
      )}
      {table.rows.length < table.count ? <button type="button" onClick={() => model.showMore()}>Show more elements</button> : null}
    </main>
  );
}

function countText({ rows, count }: ArrayTable): string {
  const elements = count === 1 ? "1 element" : `${count} elements`;
  return rows.length < count ? `the first ${rows.length} of ${elements}` : elements;
}

function Elements({ model, table }: { model: TableModel; table: ArrayTable }): JSX.Element {
  const columns = columnsOf(table);
  const selected = model.selected.value;
  const { box, first, end, onScroll } = useVisibleRows(table.rows.length, ROW);
  useEffect(() => {
    if (box.current !== null && selected >= 0) {
      revealRow(box.current, selected, ROW);
    }
  }, [selected, box]);
  return (
    <div class="rows" ref={box} onScroll={onScroll} tabIndex={0} role="region" aria-label={`Elements of ${table.name}`}>
      <table aria-rowcount={table.rows.length + 1}>
        <thead>
          <tr aria-rowindex={1}>{columns.map(({ heading, isNumber }) => <th key={heading} scope="col" class={isNumber ? "number" : undefined}>{heading}</th>)}</tr>
        </thead>
        <tbody>
          <Spacer height={first * ROW} columns={columns.length} />
          {table.rows.slice(first, end).map((row, at) => (
            <tr key={row.index} aria-rowindex={first + at + 2} class={first + at === selected ? "selected" : undefined} title={row.value} onClick={() => model.select(first + at)}>
              {columns.map(({ heading, text, isNumber }) => <td key={heading} class={isNumber ? "value number" : "value"}>{text(row)}</td>)}
            </tr>
          ))}
          <Spacer height={(table.rows.length - end) * ROW} columns={columns.length} />
        </tbody>
      </table>
    </div>
  );
}
