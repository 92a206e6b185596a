// Motion queue: the present move and the waiting moves.

import type { JSX } from "preact";
import type { Cell } from "../shared/cell";
import { Place } from "../shared/Place";
import { fixed } from "../shared/fixed";

export function MotionQueue({ cell }: { cell: Cell }): JSX.Element {
  const { queue } = cell.motion.value;
  return (
    <div class="scroll" tabIndex={0} role="region" aria-label="Motion queue">
      <table>
        <caption>Motion queue: {queue.length} {queue.length === 1 ? "move" : "moves"}</caption>
        <thead>
          <tr><th scope="col">Id</th><th scope="col">Type</th><th scope="col">Line</th><th scope="col">Phase</th><th scope="col">Leave</th><th scope="col">Reach</th><th scope="col">Blend cut short</th><th scope="col">Target</th></tr>
        </thead>
        <tbody>
          {queue.map(({ id, type, program, line, file, phase, leaveDistance, reachDistance, blendCutShort, target }) => (
            <tr key={id}>
              <th scope="row">{id}</th>
              <td>{type}</td>
              <td><Place cell={cell} program={program} line={line} file={file} /></td>
              <td>{phase}</td>
              <td>{distance(leaveDistance)}</td>
              <td>{distance(reachDistance)}</td>
              <td>{blendCutShort ?? "–"}</td>
              <td class="coordinates">{target.map((part) => fixed(part, 1)).join("  ")}</td>
            </tr>
          ))}
          {queue.length === 0 ? <tr><td colSpan={8}>No move is recorded.</td></tr> : null}
        </tbody>
      </table>
    </div>
  );
}

function distance(mm: number | null): string {
  return mm === null ? "–" : `${mm.toFixed(1)} mm`;
}
