// Points of the application: their values, teaching, and saving to the .dtx.

import type { JSX } from "preact";
import { useMemo, useState } from "preact/hooks";
import { type Cell, type CellPoint, Notice } from "../shared/cell";
import { LongTable } from "../shared/LongTable";
import { MessageLine } from "../shared/NoticeLine";
import { COORDINATES, coordinateTitle, fatherText, fieldTexts, pointText, samePoint } from "./edits";
import { FramesAndTools } from "./FramesAndTools";
import { JointsTable } from "./JointsTable";
import { PointEditor } from "./PointEditor";
import { SaveBar } from "./SaveBar";
import { ToolChoice } from "./ToolChoice";
import { ReachMark } from "./ReachMark";
import { poseTexts, unitOf } from "../shared/lengths";

export function PointsPanel({ cell }: { cell: Cell }): JSX.Element {
  const notice = useMemo(() => new Notice(), []);
  const [text, setText] = useState("");
  const [tool, reach, frames] = [cell.chosenTool.value, cell.unreachable.value.reasons, cell.frames.value];
  const unit = unitOf(cell.scene.value);
  const columns = ["Point", "Father", ...COORDINATES.map((_, at) => coordinateTitle(at, unit)), "In world"];
  const points = cell.points.value;
  const fathers = useMemo(() => new Map(frames.map((frame) => [pointText(frame), frame.father])), [frames]);
  const unsaved = cell.unsaved.value;
  const words = text.toLowerCase().split(/\s+/).filter((word) => word !== "");
  const shown = points.filter((point) => words.every((word) => `${pointText(point)} ${point.father ?? ""}`.toLowerCase().includes(word)));
  const isEdited = (point: CellPoint): boolean => unsaved.has(pointText(point));
  const selected = cell.selectedPoint.value;
  const present = selected && points.find((point) => samePoint(point, selected));
  return (
    <section class="panel points" aria-label="Points">
      <MessageLine cell={cell} notice={notice} />
      <div class="row tools">
        <input type="search" aria-label="Filter points" placeholder="Filter" value={text} onInput={({ currentTarget }) => setText(currentTarget.value)} />
        <span class="count" role="status">{shown.length} of {points.length}</span>
        <ToolChoice cell={cell} />
        <SaveBar cell={cell} notice={notice} changed={unsaved.size} />
      </div>
      <LongTable<CellPoint>
        label="Points of the application" className="point-table" columns={columns} rows={shown} empty={points.length === 0 ? "The application has no points." : "No point matches the filter."}
        keyOf={pointText} rowClass={(point) => (isEdited(point) ? "changed" : undefined)} onRowClick={(point) => cell.selectPoint(point)}
        isSelected={(point) => selected !== undefined && samePoint(point, selected)}
        cells={(point) => (
          <>
            <th scope="row"><button type="button" class="place" onClick={() => cell.selectPoint(point)}>{pointText(point)}</button>{isEdited(point) ? <span class="edited"> changed</span> : null}<ReachMark reason={reach.get(pointText(point))} /></th>
            <td title={fatherText(point.father, fathers)}>{point.father ?? "world"}</td>
            {fieldTexts(point.local, unit).map((field, at) => <td class="figure" key={at}>{field}</td>)}
            <td class="coordinates">{poseTexts(point.pose, 1, unit).join("  ")}</td>
          </>
        )}
      />
      {present === undefined ? <p class="hint">Choose a point to change it, or to move the arm there.</p> : <PointEditor key={`${pointText(present)} ${present.father ?? ""} ${present.local.join()} ${present.config ?? ""}`} cell={cell} notice={notice} point={present} tool={tool} fathers={fatherText(present.father, fathers)} />}
      <JointsTable cell={cell} notice={notice} joints={cell.joints.value} reach={reach} />
      <FramesAndTools cell={cell} notice={notice} tool={tool} />
    </section>
  );
}
