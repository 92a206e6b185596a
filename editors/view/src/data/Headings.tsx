// Column headings, which sort the table.

import type { JSX } from "preact";
import type { GridColumn } from "./columns";
import type { DataModel } from "./model";
import { nextOrder } from "./sorting";

export function Headings({ model, columns }: { model: DataModel; columns: readonly GridColumn[] }): JSX.Element {
  const order = model.order.value;
  return (
    <thead>
      <tr aria-rowindex={1}>
        {columns.map(({ id, title, unit, kind, isFigure = false }, index) => {
          const sort = order?.column === id ? (order.isDescending ? "descending" : "ascending") : "none";
          return (
            <th key={id} scope="col" role="columnheader" aria-colindex={index + 1} aria-sort={sort} class={isFigure ? `${kind} figure` : kind} title={headingTitle(title, unit, sort)}>
              {title === "" || kind === "world" || kind === "reach"
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
