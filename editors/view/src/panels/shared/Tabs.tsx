// Tabs within a panel; the arrow keys move between them.

import type { ComponentChildren, JSX, TargetedKeyboardEvent } from "preact";
import { useRef } from "preact/hooks";
import { showTab, tabChoice } from "./tabChoice";

export interface Tab {
  id: string;
  label: string;
  /** Number of faults, shown in the label. */
  faults?: number;
  content: () => ComponentChildren;
}

export function Tabs({ label, tabs }: { label: string; tabs: readonly Tab[] }): JSX.Element {
  const chosen = tabChoice(label).value;
  const shown = tabs.find(({ id }) => id === chosen)?.id ?? tabs[0]?.id ?? "";
  const show = (id: string): void => showTab(label, id);
  const list = useRef<HTMLDivElement>(null);
  const move = (event: TargetedKeyboardEvent<HTMLDivElement>): void => {
    const next = nextTab(tabs.findIndex(({ id }) => id === shown), tabs.length, event.key);
    const tab = next === undefined ? undefined : tabs[next];
    if (tab !== undefined) {
      event.preventDefault();
      show(tab.id);
      list.current?.querySelector<HTMLElement>(`#tab-${tab.id}`)?.focus();
    }
  };
  const present = tabs.find(({ id }) => id === shown);
  return (
    <>
      <div class="tabs" role="tablist" aria-label={label} ref={list} onKeyDown={move}>
        {tabs.map(({ id, label, faults = 0 }) => (
          <button
            key={id} type="button" role="tab" id={`tab-${id}`} aria-selected={id === shown} aria-controls={`content-${id}`}
            tabIndex={id === shown ? 0 : -1} onClick={() => show(id)}
          >
            {label}{faults === 0 ? null : <span class="fault-count" aria-label={`${faults} ${faults === 1 ? "fault" : "faults"}`}>{faults}</span>}
          </button>
        ))}
      </div>
      {tabs.map(({ id }) => (
        <div key={id} class="tab-content" role="tabpanel" id={`content-${id}`} aria-labelledby={`tab-${id}`} hidden={id !== shown}>
          {id === present?.id ? present.content() : null}
        </div>
      ))}
    </>
  );
}

/** Returns the tab to which a key moves. */
export function nextTab(present: number, count: number, key: string): number | undefined {
  switch (key) {
    case "ArrowRight": return (present + 1) % count;
    case "ArrowLeft": return (present + count - 1) % count;
    case "Home": return 0;
    case "End": return count - 1;
    default: return undefined;
  }
}
