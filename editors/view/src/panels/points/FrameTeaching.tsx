// Buttons that record positions of the arm, and compute a frame or tool from them.

import type { JSX } from "preact";
import { useState } from "preact/hooks";
import { Button } from "../shared/Button";
import type { Cell, Notice } from "../shared/cell";
import { unitOf } from "../shared/lengths";
import { type PointName, pointText } from "./edits";
import { HINTS, POSITIONS, type TaughtJoints, type TaughtKind, taughtText, teachingCommand } from "./taughtPositions";
import { type ChosenTool, toolText } from "./tools";

interface Props {
  cell: Cell;
  notice: Notice;
  kind: TaughtKind;
  value: PointName;
  tool: ChosenTool;
}

export function FrameTeaching({ cell, notice, kind, value, tool }: Props): JSX.Element {
  const [joints, setJoints] = useState<TaughtJoints>(() => POSITIONS[kind].map(() => undefined));
  const [result, setResult] = useState("");
  const refused = (reason: string): void => void (notice.text.value = reason);
  const blocked = cell.blocked.value;
  const next = teachingCommand(kind, value, tool, joints);
  const record = (index: number): void => {
    setJoints(joints.with(index, cell.sample.peek()?.joints));
    setResult("");
  };
  const compute = async (): Promise<void> => {
    if ("command" in next) {
      const answer = await notice.send(cell, next.command, next.args);
      setResult(answer === undefined ? "" : taughtText(kind, answer, unitOf(cell.scene.value)));
    }
  };
  const details = kind === "frame" ? ` with tool ${toolText(tool, cell.sample.value?.toolName)}` : "";
  return (
    <div class="frame-teaching" role="group" aria-label={`Teach ${pointText(value)}`}>
      <p class="hint">{HINTS[kind]}</p>
      <div class="row">
        {POSITIONS[kind].map((name, index) => (
          <Button key={name} isPressed={joints[index] !== undefined} reason={blocked} title="Records the present position of the arm" onPress={() => record(index)} onRefused={refused}>
            {name}{joints[index] === undefined ? "" : " ✓"}
          </Button>
        ))}
      </div>
      <div class="row">
        <Button reason={blocked ?? ("missing" in next ? `${next.missing} was not taught.` : undefined)} onPress={() => void compute()} onRefused={refused}>Compute {pointText(value)}{details}</Button>
        <span role="status">{result}</span>
      </div>
    </div>
  );
}
