// Cycle times of the run, from each occurrence of the chosen event to the next one.

import type { JSX } from "preact";
import { useState } from "preact/hooks";
import type { Cell } from "../shared/cell";
import { type CycleRow, cyclesOf, moverOf, PARTS, repeatedEvents, summaryOf } from "./cycles";
import { share } from "./times";

/** Last cycles in the table. */
const SHOWN = 50;

export function CycleTable({ cell, until }: { cell: Cell; until: number }): JSX.Element {
  const [chosen, setChosen] = useState("");
  const { history } = cell;
  const events = repeatedEvents(history.moves.all(), cell.scene.value?.signals ?? [], history.signals, until);
  const mover = moverOf(history.events);
  const times = events.find(({ name }) => name === chosen)?.times ?? [];
  const waits = mover === undefined ? [] : history.segments.of(mover);
  const cycles = times.length < 2 ? [] : cyclesOf(times, [...history.rests()], waits);
  return (
    <section aria-label="Cycle times">
      <p class="reason">
        <label>
          Cycles from each{" "}
          <select value={chosen} onChange={({ currentTarget }) => setChosen(currentTarget.value)}>
            <option value="">{events.length === 0 ? "(nothing repeats yet)" : "(choose an event)"}</option>
            {events.map(({ name, times: { length } }) => <option key={name} value={name}>{`${name} (${length} times)`}</option>)}
          </select>{" "}
          to the next one
        </label>
      </p>
      {cycles.length === 0 ? null : <Summary cycles={cycles} mover={mover} />}
      {cycles.length === 0 ? null : <Rows cell={cell} cycles={cycles} />}
    </section>
  );
}

function Summary({ cycles, mover }: { cycles: readonly CycleRow[]; mover: string | undefined }): JSX.Element | null {
  const summary = summaryOf(cycles);
  if (summary === undefined) {
    return null;
  }
  const { count, first, min, mean, max } = summary;
  return (
    <table>
      <caption>{count} {count === 1 ? "cycle" : "cycles"}: first {first.toFixed(3)} s, min {min.toFixed(3)} s, mean {mean.toFixed(3)} s, max {max.toFixed(3)} s</caption>
      <thead>
        <tr><th scope="col" class="figure">Mean seconds</th><th scope="col" class="figure">Share</th><th scope="col">Part</th></tr>
      </thead>
      <tbody>
        {PARTS.filter(([part]) => summary[part] > 1e-6).map(([part, name]) => (
          <tr key={part}>
            <td class="figure">{summary[part].toFixed(3)}</td><td class="figure">{share(summary[part], mean)}</td>
            <td>{part === "moving" || mover === undefined ? name : `${name} (${mover})`}</td>
          </tr>
        ))}
      </tbody>
    </table>
  );
}

function Rows({ cell, cycles }: { cell: Cell; cycles: readonly CycleRow[] }): JSX.Element {
  const shown = cycles.slice(-SHOWN);
  return (
    <table>
      <caption>{shown.length < cycles.length ? `Last ${shown.length} cycles` : "Cycles"}</caption>
      <thead>
        <tr><th scope="col" class="figure">Begins at</th><th scope="col" class="figure">Seconds</th><th scope="col" class="figure">Arm moves</th></tr>
      </thead>
      <tbody>
        {shown.map(({ from, to, moving }) => (
          <tr key={from}>
            <td class="figure"><button type="button" title="Show this time" onClick={() => cell.seek(from)}>{from.toFixed(3)} s</button></td>
            <td class="figure">{(to - from).toFixed(3)}</td><td class="figure">{share(moving, to - from)}</td>
          </tr>
        ))}
      </tbody>
    </table>
  );
}
