// Choice of the tool with which points are taught and reached.

import type { JSX } from "preact";
import type { Cell } from "../shared/cell";
import { pointText } from "./edits";
import { type ChosenTool, FLANGE } from "./tools";

const LAST = "";

interface Props {
  cell: Cell;
  tool: ChosenTool;
  onChange: (tool: ChosenTool) => void;
}

export function ToolChoice({ cell, tool, onChange }: Props): JSX.Element {
  const tools = [FLANGE, ...(cell.scene.value?.tools ?? [])];
  const last = cell.sample.value?.toolName;
  const choose = (text: string): void => onChange(tools.find((candidate) => pointText(candidate) === text));
  return (
    <label>Tool{" "}
      <select value={tool === undefined ? LAST : pointText(tool)} onChange={({ currentTarget }) => choose(currentTarget.value)}>
        <option value={LAST}>of the last move{last == null ? "" : ` (${last})`}</option>
        {tools.map((candidate) => <option key={pointText(candidate)} value={pointText(candidate)}>{pointText(candidate)}</option>)}
      </select>
    </label>
  );
}
