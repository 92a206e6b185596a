// Shown tab in each list of tabs, by name. The choice survives a reload.

import { type Signal, signal } from "@preact/signals";
import { remember, remembered } from "../../memory";

/** Name of the list that contains the panels of the cell. */
export const CELL_TABS = "Cell";

const choices = new Map<string, Signal<string | undefined>>();

/** Returns the chosen tab of a list; `undefined` until the user chooses one. */
export function tabChoice(list: string): Signal<string | undefined> {
  const known = choices.get(list) ?? signal(remembered(`tab.${list}`));
  choices.set(list, known);
  return known;
}

export function showTab(list: string, id: string): void {
  tabChoice(list).value = id;
  remember(`tab.${list}`, id);
}
