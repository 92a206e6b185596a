// Frames taught by three positions of the arm, and tools taught by four.

import type { JSX } from "preact";
import { useState } from "preact/hooks";
import type { Cell, CellPoint, Notice } from "../shared/cell";
import { unitOf } from "../shared/lengths";
import { COORDINATES, fieldTexts, pointText } from "./edits";
import { FrameTeaching } from "./FrameTeaching";
import type { TaughtKind } from "./taughtPositions";
import type { ChosenTool } from "./tools";

interface Props {
  cell: Cell;
  notice: Notice;
  tool: ChosenTool;
}

export function FramesAndTools({ cell, notice, tool }: Props): JSX.Element | null {
  const [text, setText] = useState("");
  const unit = unitOf(cell.scene.value);
  const [frames, tools] = [cell.frames.value, cell.tools.value];
  const choices: readonly { kind: TaughtKind; value: CellPoint }[] = [
    ...frames.map((value) => ({ kind: "frame" as const, value })),
    ...tools.map((value) => ({ kind: "tool" as const, value })),
  ];
  if (choices.length === 0) {
    return null;
  }
  const chosen = choices.find(({ value }) => pointText(value) === text);
  return (
    <fieldset class="frames-and-tools">
      <legend>Frames and tools</legend>
      <label>Frame or tool{" "}
        <select value={text} onChange={({ currentTarget }) => setText(currentTarget.value)}>
          <option value="">Choose one to teach it</option>
          <Choices label="Frames" values={frames} cell={cell} />
          <Choices label="Tools" values={tools} cell={cell} />
        </select>
      </label>
      {chosen === undefined ? null : (
        <>
          <p class="coordinates">{fieldTexts(chosen.value.local, unit).map((field, at) => `${COORDINATES[at] ?? ""} ${field}`).join("  ")}{unit.mm === 1 ? "" : ` (lengths: ${unit.long})`} in {chosen.value.father ?? (chosen.kind === "frame" ? "world" : "flange")}</p>
          <FrameTeaching key={text} cell={cell} notice={notice} kind={chosen.kind} value={chosen.value} tool={tool} />
        </>
      )}
    </fieldset>
  );
}

function Choices({ label, values, cell }: { label: string; values: readonly CellPoint[]; cell: Cell }): JSX.Element | null {
  return values.length === 0 ? null : (
    <optgroup label={label}>
      {values.map(pointText).map((name) => <option key={name} value={name}>{name}{cell.unsaved.value.has(name) ? " (changed)" : ""}</option>)}
    </optgroup>
  );
}
