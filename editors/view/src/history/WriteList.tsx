// List of the writes, the newest first. Only the visible rows are in the document.

import type { JSX, TargetedKeyboardEvent } from "preact";
import { useEffect } from "preact/hooks";
import { Spacer } from "../panels/shared/Spacer";
import { useVisibleRows } from "../panels/shared/useVisibleRows";
import type { HistoryModel } from "./model";
import { revealRow } from "./revealRow";
import { placeOf, timeText } from "./steps";

/** Height of a row in px, as in history.css. */
const ROW = 24;
const COLUMNS = ["Time", "Value", "Line", "Task"] as const;

export function WriteList({ model }: { model: HistoryModel }): JSX.Element {
  const steps = model.steps.value;
  const selected = model.selected.value;
  const history = model.history.value;
  const name = history?.name ?? "";
  const { box, first, end, onScroll } = useVisibleRows(steps.length, ROW);
  const rowOf = (index: number): number => steps.length - 1 - index;
  useEffect(() => {
    if (box.current !== null && selected >= 0) {
      revealRow(box.current, rowOf(selected), ROW);
    }
  }, [selected, steps, box]);
  const rows = steps.slice(Math.max(0, steps.length - end), steps.length - first).reverse();
  return (
    <div class="writes">
      <div
        class="rows" ref={box} onScroll={onScroll} onKeyDown={(event) => press(event, model)} tabIndex={0} role="grid"
        aria-label={`Writes of ${name}`} aria-rowcount={steps.length + 1} aria-activedescendant={selected >= 0 ? `step-${selected}` : undefined}
      >
        <table role="presentation">
          <thead role="rowgroup">
            <tr role="row" aria-rowindex={1}>{COLUMNS.map((column) => <th key={column} role="columnheader" scope="col">{column}</th>)}</tr>
          </thead>
          <tbody role="rowgroup">
            <Spacer height={first * ROW} columns={COLUMNS.length} />
            {rows.map((step, at) => {
              const index = steps.length - 1 - first - at;
              return (
                <tr
                  key={index} id={`step-${index}`} role="row" aria-rowindex={first + at + 2} aria-selected={index === selected}
                  class={step.write?.source == null ? undefined : "opens"} onClick={() => { model.select(index); model.open(index, false); }}
                >
                  <td role="gridcell" class="time">{timeText(step.t)}</td>
                  <td role="gridcell" class="value" title={step.value}>{step.value}</td>
                  <td role="gridcell" title={step.write?.source?.file}>{step.write === undefined ? "before these writes" : placeOf(step, name)}</td>
                  <td role="gridcell">{step.write?.task ?? ""}</td>
                </tr>
              );
            })}
            <Spacer height={(steps.length - end) * ROW} columns={COLUMNS.length} />
          </tbody>
        </table>
      </div>
      {history?.more === true ? <button type="button" onClick={() => model.showEarlier()}>Show earlier writes</button> : null}
    </div>
  );
}

function press(event: TargetedKeyboardEvent<HTMLElement>, model: HistoryModel): void {
  const [index, last] = [model.selected.peek(), model.steps.peek().length - 1];
  const page = Math.max(1, Math.floor(event.currentTarget.clientHeight / ROW) - 2);
  const to: Record<string, number> = { ArrowDown: index - 1, ArrowUp: index + 1, PageDown: index - page, PageUp: index + page, Home: last, End: 0 };
  const target = to[event.key];
  if (target !== undefined) {
    event.preventDefault();
    model.select(Math.max(0, Math.min(last, target)));
  } else if (event.key === "Enter") {
    event.preventDefault();
    model.open(index, true);
  }
}
