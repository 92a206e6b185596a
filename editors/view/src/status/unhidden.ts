// Faults that the bar shows, because the user has not hidden them.

import type { Fault } from "../panels/tasks/faults";

/** Returns a text that identifies a fault, also after the history was read again. */
export function keyOf({ t, text }: Fault): string {
  return `${t} ${text}`;
}

export function unhidden(faults: readonly Fault[], hidden: ReadonlySet<string>): readonly Fault[] {
  return hidden.size === 0 ? faults : faults.filter((fault) => !hidden.has(keyOf(fault)));
}

/** Returns the index of the chosen fault, otherwise of the last one. */
export function latestOf(faults: readonly Fault[], chosen: string | undefined): number {
  const index = chosen === undefined ? -1 : faults.findIndex((fault) => keyOf(fault) === chosen);
  return index < 0 ? faults.length - 1 : index;
}
