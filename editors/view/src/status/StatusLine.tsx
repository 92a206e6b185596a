// Status line of the page.

import type { JSX } from "preact";
import { useEffect } from "preact/hooks";
import type { Store } from "../store";
import { type StatusFacts, statusOf } from "./status";
import "./status.css";

export function StatusLine({ store }: { store: Store }): JSX.Element {
  const facts: StatusFacts = {
    lost: store.lost.value, end: store.end.value, role: store.scene.value?.role, isPast: store.chosen.value !== undefined,
    isPaused: store.isPaused.value, isStopped: store.isStopped.value, isSilent: store.isSilent.value,
    awaited: store.awaited.value, isInEditor: store.openLine.value !== undefined, state: store.panels.cell.state.value,
  };
  const { kind, text, word } = statusOf(facts);
  const application = store.scene.value?.application;
  useEffect(() => {
    document.title = application === undefined ? "VAL 3" : `${application} – ${word}`;
  }, [application, word]);
  return <p class={`status-line ${kind}`} role="status" aria-label="Status" title={text}>{text}</p>;
}
