// Choice of the frame in which a point is taught.

import type { JSX } from "preact";
import type { CellPoint } from "../shared/cell";
import { type PointName, pointText } from "./edits";
import { type ChosenFrame, framesFor, frameText } from "./frames";

const FATHER = "";

interface Props {
  point: CellPoint;
  frames: readonly PointName[];
  frame: ChosenFrame;
  onChoose: (frame: ChosenFrame) => void;
}

export function FrameChoice({ point, frames, frame, onChoose }: Props): JSX.Element {
  const others = framesFor(point, frames);
  return (
    <label title="The taught point is stored in this frame, which becomes its father">Frame{" "}
      <select value={frame === undefined ? FATHER : pointText(frame)} onChange={({ currentTarget: { value } }) => onChoose(others.find((other) => pointText(other) === value))}>
        <option value={FATHER}>{frameText(undefined, point.father)}</option>
        {others.map((other) => <option key={pointText(other)} value={pointText(other)}>{pointText(other)}</option>)}
      </select>
    </label>
  );
}
