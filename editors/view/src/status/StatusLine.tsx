// Status line of the page, and the bar of a fault.

import type { JSX } from "preact";
import { useEffect, useState } from "preact/hooks";
import type { Store } from "../store";
import { countUpTo } from "../panels/tasks/upTo";
import { type StatusFacts, statusOf } from "./status";
import "./status.css";

export function StatusLine({ store }: { store: Store }): JSX.Element {
  const facts: StatusFacts = {
    lost: store.lost.value, end: store.end.value, role: store.scene.value?.role, isPast: store.chosen.value !== undefined,
    isPaused: store.isPaused.value, isStopped: store.isStopped.value, isSilent: store.isSilent.value, state: store.panels.cell.state.value,
  };
  const { kind, text, word } = statusOf(facts);
  const application = store.scene.value?.application;
  useEffect(() => {
    document.title = application === undefined ? "VAL 3" : `${application} – ${word}`;
  }, [application, word]);
  return <p class={`status-line ${kind}`} role="status" aria-label="Status" title={text}>{text}</p>;
}

export function FaultBar({ store }: { store: Store }): JSX.Element | null {
  const { cell } = store.panels;
  const { faults } = cell.history;
  const count = countUpTo(faults, cell.slowTime.value);
  const [hiddenUpTo, setHidden] = useState(-1);
  const last = faults[count - 1];
  if (last === undefined || last.t <= hiddenUpTo) {
    return null;
  }
  const { source } = last;
  const openLine = cell.openLine.value;
  return (
    <div class="fault-bar" role="alert" aria-label="Fault">
      <strong>{last.text}</strong>
      {count === 1 ? null : <span>{count} faults</span>}
      <button type="button" onClick={() => cell.seek(last.t)}>Show {last.t.toFixed(3)} s</button>
      {source !== undefined && openLine !== undefined ? <button type="button" onClick={() => openLine(source)}>Open the line</button> : null}
      <button type="button" aria-label="Hide this fault" onClick={() => setHidden(last.t)}>×</button>
    </div>
  );
}
