// Row of the table.

import type { JSX } from "preact";
import { isNamed } from "./actions";
import { CellEditor } from "./CellEditor";
import { cellId, type CellContent, contentOf } from "./cells";
import type { GridColumn } from "./columns";
import { messagesOf } from "./findings";
import type { DataModel, Editing } from "./model";
import { placeId } from "./place";
import { poseTitle, reachText, worldText } from "./poses";
import type { DataFinding } from "./protocol";
import type { Row } from "./rows";

interface RowProps {
  model: DataModel;
  row: Row;
  index: number;
  columns: readonly GridColumn[];
  /** Selected columns; both are -1 if there are none. */
  left: number;
  right: number;
  /** Column of the active cell, or -1. */
  active: number;
  editing: Editing | undefined;
  onEnd: (down: number, right: number) => void;
}

/** Reads a signal, so that the row is drawn again only if its properties have changed. */
export function GridRow({ model, row, index, columns, left, right, active, editing, onEnd }: RowProps): JSX.Element {
  const findings = model.findings.value;
  const isPosed = columns.some(({ kind }) => kind === "world");
  const pose = isPosed && row.element !== undefined ? model.poses.known.value.get(placeId(row.element)) : undefined;
  return (
    <tr
      class={row.kind} aria-rowindex={index + 2} aria-level={row.depth + 1} aria-expanded={row.isExpandable ? row.isExpanded : undefined}
      aria-selected={left >= 0 ? true : undefined}
    >
      {columns.map((column, at) => {
        const content = contentOf(row, column);
        const found = column.kind === "name" && !row.isExpanded && row.kind === "datum" && row.element === undefined ? findings.below(row.datum.name) : ownFindings(findings.of(cellId(row, column)), column);
        const isEdited = editing?.column === column.id;
        const text = column.kind === "world" ? (pose === undefined ? "" : worldText(pose)) : column.kind === "reach" ? (pose === undefined ? "" : reachText(pose)) : content.text;
        const title = [found.length > 0 ? messagesOf(found) : "", isPose(column) && pose !== undefined ? poseTitle(pose) : text].join("\n").trim();
        return (
          <td
            key={column.id} id={`cell-${index}-${at}`} role={column.kind === "name" ? "rowheader" : "gridcell"} aria-colindex={at + 1} data-row={index} data-column={at} title={title}
            class={classOf(column, content, found, { isSelected: left <= at && at <= right && left >= 0, isActive: at === active, isOutOfReach: column.kind === "reach" && pose?.reach === "outOfReach", isEdited })}
            aria-selected={left <= at && at <= right && left >= 0} aria-invalid={found.length > 0 ? true : undefined} aria-readonly={isReadOnly(row, column, content) ? true : undefined}
            style={column.kind === "name" ? { paddingLeft: `${6 + 14 * row.depth}px` } : undefined}
          >
            {isEdited ? <CellEditor model={model} editing={editing} row={row} column={column} onEnd={onEnd} /> : <Content row={row} column={column} content={content} text={text} />}
          </td>
        );
      })}
    </tr>
  );
}

function Content({ row, column, content, text }: { row: Row; column: GridColumn; content: CellContent; text: string }): JSX.Element {
  const label = column.title === "" && content.column !== undefined ? <span class="label">{content.column.title} </span> : null;
  const unit = label === null || content.column?.unit == null ? null : <span class="label"> {content.column.unit}</span>;
  if (column.kind === "name") {
    return <>{row.isExpandable ? <span class="twistie" aria-hidden="true">{row.isExpanded ? "▾" : "▸"}</span> : <span class="twistie" aria-hidden="true" />}{text}</>;
  } else if (content.column?.kind === "bool") {
    return <>{label}<input type="checkbox" tabIndex={-1} aria-label={`${row.label} ${content.column.title}`} checked={content.text === "true"} readOnly /></>;
  }
  return <>{label}{text}{unit}</>;
}

function isPose({ kind }: GridColumn): boolean {
  return kind === "world" || kind === "reach";
}

/** A finding about an entire datum is shown only at its name. */
function ownFindings(found: readonly DataFinding[], { kind }: GridColumn): readonly DataFinding[] {
  return kind === "name" || kind === "value" ? found : [];
}

function isReadOnly(row: Row, { kind }: GridColumn, content: CellContent): boolean {
  switch (kind) {
    case "name": return !isNamed(row);
    case "access": return row.kind !== "datum";
    case "size": return row.kind === "element" || row.datum.container === "collection";
    case "value": return content.column === undefined;
    default: return true;
  }
}

interface Look {
  isSelected: boolean;
  isActive: boolean;
  isOutOfReach: boolean;
  isEdited: boolean;
}

function classOf({ kind, isFigure = false }: GridColumn, content: CellContent, found: readonly DataFinding[], look: Look): string {
  const worst = (["error", "warning", "information", "hint"] as const).find((severity) => found.some((finding) => finding.severity === severity));
  return [
    kind, isFigure ? "figure" : "", content.isDefault ? "default" : "", worst === undefined ? "" : `finding ${worst}`,
    look.isSelected ? "selected" : "", look.isActive ? "active" : "", look.isOutOfReach ? "bad" : "", look.isEdited ? "edited" : "",
  ].filter((name) => name !== "").join(" ");
}
