// Details of the active cell: its full text and its findings.

import type { JSX } from "preact";
import { cellId } from "./cells";
import { messagesOf } from "./findings";
import type { DataModel } from "./model";
import { placeId } from "./place";
import { poseTitle } from "./poses";

export function StatusLine({ model }: { model: DataModel }): JSX.Element {
  const [row, column] = [model.activeRow(), model.activeColumn()];
  const { text, title } = model.activeText();
  const findings = row === undefined || column === undefined ? [] : column.kind === "name" ? model.findings.value.below(row.container.name) : model.findings.value.of(cellId(row, column));
  const pose = row?.element === undefined ? undefined : model.poses.known.value.get(placeId(row.element));
  const rectangle = model.rectangle.value;
  const size = rectangle && { height: rectangle.bottom - rectangle.top + 1, width: rectangle.right - rectangle.left + 1 };
  return (
    <div class="status" role="status">
      <span class="cell-text"><strong>{title}</strong> {text}</span>
      {findings.length > 0 ? <span class="verdict">{messagesOf(findings)}</span> : null}
      {pose === undefined ? null : <span class="pose">{poseTitle(pose).replaceAll("\n", " · ")}</span>}
      <span class="space" />
      <span>{size !== undefined && size.height * size.width > 1 ? `${size.height} × ${size.width} cells` : ""}</span>
    </div>
  );
}
