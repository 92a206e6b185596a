// Column headings, which sort the table.

import type { JSX } from "preact";
import type { GridColumn } from "./columns";
import type { DataModel } from "./model";
import { nextOrder } from "./sorting";

/** Meanings of the computed columns, which do not sort the table. */
const HINTS: Partial<Record<GridColumn["kind"], string>> = {
  world: "Pose in world; of a tool: on the flange. Computed from the fathers in the file.",
  reach: "Whether the arm reaches the value with the tool of its moves. The arm is named in val3.toml or arm.cfx.",
};

export function Headings({ model, columns }: { model: DataModel; columns: readonly GridColumn[] }): JSX.Element {
  const order = model.order.value;
  return (
    <thead>
      <tr aria-rowindex={1}>
        {columns.map(({ id, title, unit, kind, isFigure = false }, index) => {
          const isSortable = title !== "" && HINTS[kind] === undefined;
          const sort = order?.column === id ? (order.isDescending ? "descending" : "ascending") : "none";
          return (
            <th key={id} scope="col" role="columnheader" aria-colindex={index + 1} aria-sort={sort} class={isFigure ? `${kind} figure` : kind} title={isSortable ? headingTitle(title, unit, sort) : HINTS[kind] ?? title}>
              {!isSortable
                ? <span>{title === "" ? <span class="hidden">Value {index}</span> : title} <Unit unit={unit} /></span>
                : <button type="button" tabIndex={-1} onMouseDown={(event) => event.preventDefault()} onClick={() => (model.order.value = nextOrder(order, id))}>{title} <Unit unit={unit} /><span class="order" aria-hidden="true">{{ ascending: " ▲", descending: " ▼", none: "" }[sort]}</span></button>}
            </th>
          );
        })}
      </tr>
    </thead>
  );
}

function Unit({ unit }: { unit: string | null }): JSX.Element | null {
  return unit === null ? null : <span class="unit">{unit}</span>;
}

function headingTitle(title: string, unit: string | null, sort: string): string {
  const next = { none: "ascending", ascending: "descending" }[sort];
  return `${title}${unit === null ? "" : ` (${unit})`}. Click: ${next === undefined ? "the order of the file" : `sort ${next}`}`;
}
