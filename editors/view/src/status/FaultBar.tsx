// Fault bar: cause, line of code, and remedy.

import type { JSX } from "preact";
import { useState } from "preact/hooks";
import { openingOf } from "../panels/shared/opening";
import { type Fault } from "../panels/tasks/faults";
import { countUpTo } from "../panels/tasks/upTo";
import type { Store } from "../store";
import { keyOf, latestOf, unhidden } from "./unhidden";

/** Shows the last fault; buttons change to the faults before it. */
export function FaultBar({ store }: { store: Store }): JSX.Element | null {
  const { cell } = store.panels;
  const [hidden, setHidden] = useState<ReadonlySet<string>>(new Set());
  const [chosen, setChosen] = useState<string | undefined>(undefined);
  const past = cell.history.faults.slice(0, countUpTo(cell.history.faults, cell.slowTime.value));
  const faults = unhidden(past, hidden);
  const index = latestOf(faults, chosen);
  const fault = faults[index];
  if (fault === undefined) {
    return null;
  }
  const choose = (to: number): void => setChosen(faults[to] === undefined || to === faults.length - 1 ? undefined : keyOf(faults[to]));
  const hide = (these: readonly Fault[]): void => setHidden(new Set([...hidden, ...these.map(keyOf)]));
  const { source, code, reason, help } = fault;
  const opening = source && openingOf(cell, source);
  return (
    <div class="fault-bar" role="alert" aria-label="Fault">
      <div class="row">
        <strong>{fault.text}</strong>
        {faults.length === 1 ? null : (
          <span class="row" role="group" aria-label="Faults">
            <button type="button" aria-label="Previous fault" disabled={index === 0} onClick={() => choose(index - 1)}>◀</button>
            <span>{index + 1} of {faults.length} faults</span>
            <button type="button" aria-label="Next fault" disabled={index === faults.length - 1} onClick={() => choose(index + 1)}>▶</button>
          </span>
        )}
        <button type="button" onClick={() => cell.seek(fault.t)}>Show {fault.t.toFixed(3)} s</button>
        {opening === undefined ? null : <button type="button" title={opening.title} onClick={opening.open}>Open the line</button>}
        <button type="button" aria-label="Hide this fault" onClick={() => hide([fault])}>×</button>
        {faults.length === 1 ? null : <button type="button" onClick={() => hide(faults)}>Hide all</button>}
      </div>
      {code === undefined ? null : <code>{code}</code>}
      {reason === undefined ? null : <p>{reason}</p>}
      {help === undefined ? null : <p>{help}</p>}
    </div>
  );
}
