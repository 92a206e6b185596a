// The chart as tables: the waits, and the blends that did not happen.

import type { JSX } from "preact";
import type { Cell } from "../shared/cell";
import { CodeText } from "../shared/CodeText";
import { Place } from "../shared/Place";
import { waitTotals } from "./chart";
import { cutBlends, cutText } from "./moves";

const SHOWN = 50;

export function WaitTables({ cell }: { cell: Cell }): JSX.Element {
  const [start, end] = cell.range.value;
  const until = Math.min(end, cell.slowTime.value);
  const waits = waitTotals(cell.history.segments, start, until);
  const cuts = cutBlends(cell.history.moves.all(), until).filter(({ move }) => (move.done ?? 0) >= start);
  return (
    <>
      <table>
        <caption>Waits from {start.toFixed(1)} s to {until.toFixed(1)} s</caption>
        <thead><tr><th scope="col" class="figure">Seconds</th><th scope="col" class="figure">Times</th><th scope="col">Task</th><th scope="col">Waits for</th><th scope="col">Line</th></tr></thead>
        <tbody>
          {waits.slice(0, SHOWN).map(({ task, waits, program, line, file, seconds, count }) => (
            <tr key={`${task} ${waits} ${file} ${program} ${line}`}><td class="figure">{seconds.toFixed(2)}</td><td class="figure">{count}</td><td>{task}</td><td><CodeText text={waits} /></td><td><Place cell={cell} program={program} line={line} file={file} /></td></tr>
          ))}
          {waits.length === 0 ? <tr><td colSpan={5}>No task waits in this time.</td></tr> : null}
        </tbody>
      </table>
      <table>
        <caption>Blends that did not happen: {cuts.length}</caption>
        <thead><tr><th scope="col">Time</th><th scope="col">Move</th></tr></thead>
        <tbody>
          {cuts.slice(-SHOWN).map((cut) => (
            <tr key={cut.move.id}><td><button type="button" class="place" title="Show this time" onClick={() => cell.seek(cut.move.done ?? 0)}>{(cut.move.done ?? 0).toFixed(3)} s</button></td><td>{cutText(cut)}</td></tr>
          ))}
          {cuts.length === 0 ? <tr><td colSpan={2}>None in this time.</td></tr> : null}
        </tbody>
      </table>
    </>
  );
}
