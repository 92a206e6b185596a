// Motion queue: the present move and the waiting moves.

import type { JSX } from "preact";
import type { Cell } from "../shared/cell";
import { Place } from "../shared/Place";
import { lengthText, type LengthUnit, poseTexts, unitOf } from "../shared/lengths";

/** Words for the executed part of a move. */
const PHASES: Readonly<Record<string, string>> = { waiting: "recorded", nominal: "on its path", blend: "in its blend" };

export function MotionQueue({ cell }: { cell: Cell }): JSX.Element {
  const { queue } = cell.motion.value;
  const unit = unitOf(cell.scene.value);
  return (
    <div class="scroll" tabIndex={0} role="region" aria-label="Motion queue">
      <table>
        <caption>Motion queue: {queue.length} {queue.length === 1 ? "move" : "moves"}</caption>
        <thead>
          <tr><th scope="col">Id</th><th scope="col">Type</th><th scope="col">Line</th><th scope="col">State</th><th scope="col">Leave</th><th scope="col">Reach</th><th scope="col">Blend cut short</th><th scope="col">Target</th></tr>
        </thead>
        <tbody>
          {queue.map(({ id, type, program, line, file, phase, leaveDistance, reachDistance, blendCutShort, target }) => (
            <tr key={id}>
              <th scope="row">{id}</th>
              <td>{type}</td>
              <td><Place cell={cell} program={program} line={line} file={file} /></td>
              <td>{PHASES[phase] ?? phase}</td>
              <td>{distance(leaveDistance, unit)}</td>
              <td>{distance(reachDistance, unit)}</td>
              <td>{blendCutShort ?? "–"}</td>
              <td class="coordinates">{poseTexts(target, 1, unit).join("  ")}</td>
            </tr>
          ))}
          {queue.length === 0 ? <tr><td colSpan={8}>No move is recorded.</td></tr> : null}
        </tbody>
      </table>
    </div>
  );
}

function distance(mm: number | null, unit: LengthUnit): string {
  return mm === null ? "–" : lengthText(mm, 1, unit);
}
