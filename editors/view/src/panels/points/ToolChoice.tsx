// Choice of the tool with which the operator jogs, teaches points, and checks their reach.

import type { JSX } from "preact";
import type { Cell } from "../shared/cell";
import { pointText } from "./edits";
import { FLANGE } from "./tools";

const LAST = "";

export function ToolChoice({ cell }: { cell: Cell }): JSX.Element {
  const tools = [FLANGE, ...cell.tools.value];
  const [tool, last] = [cell.chosenTool.value, cell.toolName.value];
  const choose = (text: string): void => {
    const found = tools.find((candidate) => pointText(candidate) === text);
    cell.chosenTool.value = found && { name: found.name, key: found.key };
  };
  return (
    <label>Tool{" "}
      <select value={tool === undefined ? LAST : pointText(tool)} onChange={({ currentTarget }) => choose(currentTarget.value)}>
        <option value={LAST}>{last == null ? "last move's tool" : `${last} (last move)`}</option>
        {tools.map((candidate) => <option key={pointText(candidate)} value={pointText(candidate)}>{pointText(candidate)}</option>)}
      </select>
    </label>
  );
}
