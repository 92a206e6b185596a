// Button that sets a point or joint position to the present position of the arm.

import type { JSX } from "preact";
import { Button } from "../shared/Button";
import type { Cell, Notice } from "../shared/cell";
import type { PointName } from "./edits";
import { type ChosenFrame, frameArguments } from "./frames";
import { type ChosenTool, toolArguments } from "./tools";

interface Props {
  cell: Cell;
  notice: Notice;
  point: PointName;
  tool: ChosenTool;
  /** Frame in which a point is taught; `undefined` for its present father. */
  frame?: ChosenFrame;
  /** Details of the written value, for example the tool and the configuration. */
  details: string;
}

export function TeachButton({ cell, notice, point: { name, key }, tool, frame, details }: Props): JSX.Element {
  const teach = (): void => void notice.send(cell, "teach", { name, key, ...toolArguments(tool), ...frameArguments(frame) });
  return (
    <Button reason={cell.blocked.value} title="Writes the present position of the arm" onPress={teach} onRefused={(reason) => (notice.text.value = reason)}>
      Teach here: {details}
    </Button>
  );
}
