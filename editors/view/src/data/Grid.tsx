// Table for one type: a tree of rows with keyboard navigation. Only the visible rows are in the document.

import type { JSX, TargetedClipboardEvent, TargetedKeyboardEvent, TargetedMouseEvent } from "preact";
import { useEffect, useMemo, useRef } from "preact/hooks";
import { Spacer } from "../panels/shared/Spacer";
import { useVisibleRows } from "../panels/shared/useVisibleRows";
import { copied, enter, paste } from "./actions";
import { contentOf } from "./cells";
import { hasPose } from "./columns";
import { GridRow } from "./GridRow";
import { Headings } from "./Headings";
import { pressed } from "./keys";
import type { DataModel } from "./model";
import { widthsOf } from "./widths";

/** Row height in pixels. */
const ROW_HEIGHT = 24;
const HEAD_HEIGHT = 26;

export function Grid({ model, label, empty }: { model: DataModel; label: string; empty: string }): JSX.Element {
  const [rows, columns] = [model.rows.value, model.columns.value];
  const [rectangle, selection, editing] = [model.rectangle.value, model.selection.value, model.editing.value];
  const { box, first, end, onScroll } = useVisibleRows(rows.length, ROW_HEIGHT);
  const table = useRef<HTMLTableElement>(null);
  const widths = useMemo(() => widthsOf(columns, rows), [columns, rows]);
  const active = selection && model.positionOf(selection.active);
  useEffect(() => {
    const type = model.shownType.value;
    const posed = type !== undefined && hasPose(type) ? rows.slice(first, end).filter(({ element }) => element !== undefined) : [];
    model.poses.show([...new Set(posed.map(({ container }) => container.name))]);
  }, [model, rows, first, end]);
  useEffect(() => {
    if (active !== undefined && box.current !== null) {
      scrollTo(box.current, active.row);
      document.getElementById(`cell-${active.row}-${active.column}`)?.scrollIntoView({ block: "nearest", inline: "nearest" });
    }
  }, [active?.row, active?.column, box]);
  const focus = (): void => table.current?.focus({ preventScroll: true });
  const ended = (down: number, right: number): void => {
    const at = model.selection.peek() && model.positionOf(model.selection.peek()?.active ?? { row: "", column: "" });
    if (at !== undefined && (down !== 0 || right !== 0)) {
      model.select(Math.max(0, Math.min(at.row + down, model.rows.peek().length - 1)), Math.max(0, Math.min(at.column + right, columns.length - 1)));
    }
    focus();
  };
  const keyDown = (event: TargetedKeyboardEvent<HTMLTableElement>): void => {
    if (event.target === event.currentTarget && pressed(model, event, pageRows(box.current))) {
      event.preventDefault();
      event.stopPropagation();
    }
  };
  const copy = (event: TargetedClipboardEvent<HTMLTableElement>): void => {
    const text = event.target === event.currentTarget ? copied(model) : undefined;
    if (text !== undefined) {
      event.preventDefault();
      event.clipboardData?.setData("text/plain", text);
    }
  };
  const pasteText = (event: TargetedClipboardEvent<HTMLTableElement>): void => {
    if (event.target === event.currentTarget) {
      event.preventDefault();
      void paste(model, event.clipboardData?.getData("text/plain") ?? "");
    }
  };
  return (
    <div class="grid" ref={box} onScroll={onScroll}>
      <table
        ref={table} role="treegrid" tabIndex={0} aria-label={label} aria-rowcount={rows.length + 1} aria-colcount={columns.length} aria-multiselectable
        aria-activedescendant={active === undefined ? undefined : `cell-${active.row}-${active.column}`}
        style={{ width: `${widths.reduce((sum, width) => sum + width, 0)}ch` }}
        onKeyDown={keyDown} onCopy={copy} onPaste={pasteText} onMouseDown={(event) => selectAt(model, event, focus)} onMouseOver={(event) => extendTo(model, event)}
        onDblClick={(event) => cellOf(event.target) !== undefined && editing === undefined && enter(model)} onFocus={() => model.selection.peek() === undefined && model.select(0, 0)}
      >
        <colgroup>{widths.map((width, index) => <col key={columns[index]?.id} style={{ width: `${width}ch` }} />)}</colgroup>
        <Headings model={model} columns={columns} />
        <tbody>
          <Spacer height={first * ROW_HEIGHT} columns={columns.length} />
          {rows.slice(first, end).map((row, offset) => {
            const index = first + offset;
            const isSelected = rectangle !== undefined && rectangle.top <= index && index <= rectangle.bottom;
            return (
              <GridRow
                key={row.id} model={model} row={row} index={index} columns={columns} left={isSelected ? rectangle.left : -1} right={isSelected ? rectangle.right : -1}
                active={active?.row === index ? active.column : -1} editing={editing?.row === row.id ? editing : undefined} onEnd={ended}
              />
            );
          })}
          <Spacer height={(rows.length - end) * ROW_HEIGHT} columns={columns.length} />
        </tbody>
      </table>
      {rows.length === 0 ? <p class="empty">{empty}</p> : null}
    </div>
  );
}

/** Returns the number of visible rows. */
function pageRows(box: HTMLElement | null): number {
  return Math.max(1, Math.floor(((box?.clientHeight ?? 0) - HEAD_HEIGHT) / ROW_HEIGHT) - 1);
}

/** Scrolls as little as possible until a row is visible. */
function scrollTo(box: HTMLElement, row: number): void {
  const top = row * ROW_HEIGHT;
  const height = box.clientHeight - HEAD_HEIGHT;
  if (top < box.scrollTop) {
    box.scrollTop = top;
  } else if (top + ROW_HEIGHT > box.scrollTop + height) {
    box.scrollTop = top + ROW_HEIGHT - height;
  }
}

function cellOf(target: EventTarget | null): { row: number; column: number; element: HTMLElement } | undefined {
  const element = target instanceof Element ? target.closest<HTMLElement>("[data-row]") : null;
  return element === null ? undefined : { row: Number(element.dataset["row"]), column: Number(element.dataset["column"]), element };
}

function selectAt(model: DataModel, event: TargetedMouseEvent<HTMLTableElement>, focus: () => void): void {
  const cell = cellOf(event.target);
  if (cell === undefined || event.button !== 0 || cell.element.classList.contains("edited")) {
    return;
  }
  event.preventDefault();
  model.select(cell.row, cell.column, event.shiftKey);
  focus();
  const [row, column] = [model.rows.value[cell.row], model.columns.value[cell.column]];
  const target = event.target instanceof Element ? event.target : undefined;
  if (row?.isExpandable === true && target?.classList.contains("twistie") === true) {
    model.toggle(row.id);
  } else if (target instanceof HTMLInputElement && row !== undefined && column !== undefined && contentOf(row, column).column?.kind === "bool") {
    enter(model);
  }
}

/** Extends the selection while the mouse is dragged. */
function extendTo(model: DataModel, event: TargetedMouseEvent<HTMLTableElement>): void {
  const cell = event.buttons === 1 && model.editing.peek() === undefined ? cellOf(event.target) : undefined;
  if (cell !== undefined) {
    model.select(cell.row, cell.column, true);
  }
}
