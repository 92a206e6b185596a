// A table of any number of rows, of which only those on the screen are in the document.

import type { ComponentChildren, JSX, TargetedEvent } from "preact";
import { useEffect, useRef, useState } from "preact/hooks";
import { visibleRows } from "./visibleRows";

export const ROW_HEIGHT = 28;

interface LongTableProps<Row> {
  label: string;
  className?: string;
  columns: readonly string[];
  rows: readonly Row[];
  keyOf: (row: Row, index: number) => string | number;
  /** The cells of a row. */
  cells: (row: Row) => ComponentChildren;
  rowClass?: (row: Row) => string | undefined;
  isSelected?: (row: Row) => boolean;
  onRowClick?: (row: Row) => void;
  /** Scrolls to the last row when rows are added, unless the reader has scrolled up. */
  followsEnd?: boolean;
  empty: string;
}

export function LongTable<Row>(props: LongTableProps<Row>): JSX.Element {
  const { label, className = "", columns, rows, keyOf, cells, rowClass, isSelected, onRowClick, followsEnd = false, empty } = props;
  const box = useRef<HTMLDivElement>(null);
  const [view, setView] = useState({ top: 0, height: 400 });
  const { first, end } = visibleRows(rows.length, ROW_HEIGHT, view.top, view.height);
  const isAtEnd = useRef(true);
  useEffect(() => {
    const element = box.current;
    if (element === null) {
      return undefined;
    }
    const observer = new ResizeObserver(() => setView({ top: element.scrollTop, height: element.clientHeight }));
    observer.observe(element);
    return () => observer.disconnect();
  }, []);
  useEffect(() => {
    if (followsEnd && isAtEnd.current && box.current !== null) {
      box.current.scrollTop = box.current.scrollHeight;
    }
  }, [rows.length, followsEnd]);
  const scrolled = ({ currentTarget }: TargetedEvent<HTMLDivElement>): void => {
    const { scrollTop, clientHeight, scrollHeight } = currentTarget;
    isAtEnd.current = scrollTop + clientHeight > scrollHeight - ROW_HEIGHT;
    if (visibleRows(rows.length, ROW_HEIGHT, scrollTop, clientHeight).first !== first) {
      setView({ top: scrollTop, height: clientHeight });
    }
  };
  return (
    <div class={`long ${className}`} ref={box} onScroll={scrolled} tabIndex={0} role="region" aria-label={label}>
      <table aria-label={label} aria-rowcount={rows.length + 1}>
        <thead>
          <tr aria-rowindex={1}>{columns.map((column) => <th key={column} scope="col">{column}</th>)}</tr>
        </thead>
        <tbody>
          <Spacer count={first} columns={columns.length} />
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
          <Spacer count={rows.length - end} columns={columns.length} />
        </tbody>
      </table>
      {rows.length === 0 ? <p class="empty">{empty}</p> : null}
    </div>
  );
}

function Spacer({ count, columns }: { count: number; columns: number }): JSX.Element | null {
  return count > 0 ? <tr class="spacer" aria-hidden="true"><td colSpan={columns} style={{ height: `${count * ROW_HEIGHT}px` }} /></tr> : null;
}
