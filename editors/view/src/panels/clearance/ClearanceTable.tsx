// Table of the smallest distances between things that came too near to each other.

import type { JSX } from "preact";
import type { Cell } from "../shared/cell";
import { Place } from "../shared/Place";
import { distanceText, smallestDistances } from "./encounters";

export function ClearanceTable({ cell }: { cell: Cell }): JSX.Element {
  const t = cell.slowTime.value;
  const rows = smallestDistances(cell.history.encounters.list, t);
  return (
    <div class="scroll clearances" tabIndex={0} role="region" aria-label="Smallest distances">
      {rows.length === 0 ? <p class="empty">Nothing has come nearer than its clearance up to the shown time.</p> : (
        <table>
          <caption>Smallest distances</caption>
          <thead>
            <tr><th scope="col">Things</th><th scope="col" class="figure">Distance</th><th scope="col">Time</th><th scope="col">Move</th></tr>
          </thead>
          <tbody>
            {rows.map(({ a, b, distance, at, type, program, line }) => (
              <tr key={`${a} ${b}`} class={distance > 0 ? "near" : "contact"}>
                <th scope="row">{a} – {b}</th>
                <td class="figure">{distanceText(distance)}</td>
                <td><button type="button" class="place" title="Show this time" onClick={() => cell.seek(at)}>{at.toFixed(3)} s</button></td>
                <td>{program === undefined ? "the arm stands" : <>{type} at <Place cell={cell} program={program} line={line ?? 0} /></>}</td>
              </tr>
            ))}
          </tbody>
        </table>
      )}
    </div>
  );
}
