// Types in the file, with their number of data.

import type { JSX, TargetedKeyboardEvent } from "preact";
import { useRef } from "preact/hooks";
import { nextTab } from "../panels/shared/Tabs";
import { ALL, type DataModel } from "./model";

const DIRECTIONS: Record<string, string> = { ArrowDown: "ArrowRight", ArrowUp: "ArrowLeft" };

export function TypeTabs({ model }: { model: DataModel }): JSX.Element {
  const counts = model.counts.value;
  const shown = model.shown.value;
  const list = useRef<HTMLDivElement>(null);
  const types = [ALL, ...(model.tables.value?.types ?? []).map(({ name }) => name).filter((name) => counts.has(name) || name === shown)];
  const show = (type: string): void => {
    model.shown.value = type;
    model.selection.value = undefined;
    model.editing.value = undefined;
    model.order.value = undefined;
  };
  const move = (event: TargetedKeyboardEvent<HTMLDivElement>): void => {
    const next = nextTab(types.indexOf(shown), types.length, DIRECTIONS[event.key] ?? event.key);
    const type = next === undefined ? undefined : types[next];
    if (type !== undefined && next !== undefined) {
      event.preventDefault();
      show(type);
      list.current?.querySelectorAll<HTMLElement>("[role=tab]")[next]?.focus();
    }
  };
  const isFiltered = [...counts.values()].some(({ all, found }) => all !== found);
  return (
    <div class="types" role="tablist" aria-label="Types" aria-orientation="vertical" ref={list} onKeyDown={move}>
      {types.map((type) => {
        const { all, found } = counts.get(type) ?? { all: 0, found: 0 };
        return (
          <button
            key={type} type="button" role="tab" id={`type-${type}`} aria-selected={type === shown} aria-controls="table" tabIndex={type === shown ? 0 : -1}
            class={found === 0 ? "none" : ""} title={type === ALL ? "All data of the file" : type} onClick={() => show(type)}
          >
            <span class="type-name">{type === ALL ? "All" : type}</span> <span class="count">{isFiltered ? `${found} of ${all}` : all}</span>
          </button>
        );
      })}
    </div>
  );
}
