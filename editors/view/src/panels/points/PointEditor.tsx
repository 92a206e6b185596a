// Editor of a point: fields with its values, teaching, and moving the arm to it.

import type { JSX, TargetedSubmitEvent } from "preact";
import { useState } from "preact/hooks";
import type { Cell, CellPoint, Notice } from "../shared/cell";
import { unitOf } from "../shared/lengths";
import { COORDINATES, coordinateTitle, editedTrsf, fieldTexts, pointText } from "./edits";
import { FrameChoice } from "./FrameChoice";
import { type ChosenFrame, frameText } from "./frames";
import { GoTo } from "./GoTo";
import { TeachButton } from "./TeachButton";
import { type ChosenTool, taughtConfig, toolText } from "./tools";

interface Props {
  cell: Cell;
  notice: Notice;
  point: CellPoint;
  tool: ChosenTool;
  fathers: string;
}

export function PointEditor({ cell, notice, point, tool, fathers }: Props): JSX.Element {
  const unit = unitOf(cell.scene.value);
  const [texts, setTexts] = useState(() => fieldTexts(point.local, unit));
  const [frame, setFrame] = useState<ChosenFrame>(undefined);
  const { name, key } = point;
  const blocked = cell.blocked.value;
  const config = taughtConfig(point.config, cell.state.value?.config).join("/");
  const details = `tool ${toolText(tool, cell.sample.value?.toolName)}, frame ${frameText(frame, point.father)}${config === "" ? "" : `, ${config}`}`;
  const refused = (reason: string): void => void (notice.text.value = reason);
  const apply = (): void => {
    const edited = editedTrsf(texts, point.local, unit);
    if ("wrong" in edited) {
      notice.text.value = edited.wrong;
    } else {
      void notice.send(cell, "setPoint", { name, key, local: edited.trsf });
    }
  };
  const submit = (event: TargetedSubmitEvent<HTMLFormElement>): void => {
    event.preventDefault();
    if (blocked === undefined) {
      apply();
    } else {
      refused(blocked);
    }
  };
  return (
    <form class="point-editor" aria-label={`Values of ${pointText(point)}`} onSubmit={submit}>
      <p><strong>{pointText(point)}</strong> in {fathers}{point.config ? `, ${point.config}` : ""}</p>
      <div class="row">
        {COORDINATES.map((coordinate, at) => (
          <label key={coordinate}>{coordinateTitle(at, unit)}{" "}
            <input inputMode="decimal" value={texts[at]} readOnly={blocked !== undefined} title={blocked} onInput={({ currentTarget }) => setTexts(texts.with(at, currentTarget.value))} />
          </label>
        ))}
      </div>
      <div class="row">
        <button type="submit" aria-disabled={blocked === undefined ? undefined : true} title={blocked}>Apply</button>
        <button type="button" onClick={() => setTexts(fieldTexts(point.local, unit))}>Reset fields</button>
      </div>
      <div class="row">
        <FrameChoice point={point} frames={cell.frames.value} frame={frame} onChoose={setFrame} />
        <TeachButton cell={cell} notice={notice} point={point} tool={tool} frame={frame} details={details} />
      </div>
      <GoTo cell={cell} notice={notice} point={point} tool={tool} />
    </form>
  );
}
