// Table with any number of rows. Only the visible rows are in the document.

import type { ComponentChildren, JSX, TargetedEvent } from "preact";
import { useEffect, useRef } from "preact/hooks";
import { Spacer } from "./Spacer";
import { useVisibleRows } from "./useVisibleRows";

/** Height of a row in px, as in panels.css. Fingers need higher rows. */
const ROW_HEIGHT = "matchMedia" in globalThis && matchMedia("(pointer: coarse)").matches ? 44 : 28;

interface LongTableProps<Row> {
  label: string;
  className?: string;
  columns: readonly string[];
  rows: readonly Row[];
  keyOf: (row: Row, index: number) => string | number;
  /** Returns the cells of a row. */
  cells: (row: Row) => ComponentChildren;
  rowClass?: (row: Row) => string | undefined;
  isSelected?: (row: Row) => boolean;
  onRowClick?: (row: Row) => void;
  /** Whether to scroll to the last row when rows are added, unless the user has scrolled up. */
  followsEnd?: boolean;
  empty: string;
}

export function LongTable<Row>(props: LongTableProps<Row>): JSX.Element {
  const { label, className = "", columns, rows, keyOf, cells, rowClass, isSelected, onRowClick, followsEnd = false, empty } = props;
  const { box, first, end, onScroll } = useVisibleRows(rows.length, ROW_HEIGHT);
  const isAtEnd = useRef(true);
  useEffect(() => {
    if (followsEnd && isAtEnd.current && box.current !== null) {
      box.current.scrollTop = box.current.scrollHeight;
    }
  }, [rows.length, followsEnd, box]);
  const scrolled = (event: TargetedEvent<HTMLDivElement>): void => {
    const { scrollTop, clientHeight, scrollHeight } = event.currentTarget;
    isAtEnd.current = scrollTop + clientHeight > scrollHeight - ROW_HEIGHT;
    onScroll(event);
  };
  return (
    <div class={`long ${className}`} ref={box} onScroll={scrolled} tabIndex={0} role="region" aria-label={label}>
      <table aria-label={label} aria-rowcount={rows.length + 1}>
        <thead>
          <tr aria-rowindex={1}>{columns.map((column) => <th key={column} scope="col">{column}</th>)}</tr>
        </thead>
        <tbody>
          <Spacer height={first * ROW_HEIGHT} columns={columns.length} />
          {rows.slice(first, end).map((row, index) => (
            <tr
              key={keyOf(row, first + index)}
              aria-rowindex={first + index + 2}
              class={rowClass?.(row)}
              aria-current={isSelected?.(row) === true ? true : undefined}
              onClick={onRowClick && (() => onRowClick(row))}
            >
              {cells(row)}
            </tr>
          ))}
          <Spacer height={(rows.length - end) * ROW_HEIGHT} columns={columns.length} />
        </tbody>
      </table>
      {rows.length === 0 ? <p class="empty">{empty}</p> : null}
    </div>
  );
}
