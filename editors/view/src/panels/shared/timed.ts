// Lists in chronological order.

import { countUpTo } from "../tasks/upTo";

/** Returns the last entry up to a time. */
export function latest<Entry extends { t: number }>(entries: readonly Entry[], t: number): Entry | undefined {
  return entries[countUpTo(entries, t) - 1];
}

/** States of all signals over time. */
export class TimedLevels<State extends object> {
  private readonly byLink = new Map<string, ({ t: number } & State)[]>();

  add(t: number, link: string, state: State): void {
    const own = this.byLink.get(link) ?? [];
    own.push({ ...state, t });
    this.byLink.set(link, own);
  }

  clear(): void {
    this.byLink.clear();
  }

  /** Returns all signals' states at a time. */
  at(t: number): Map<string, State> {
    const levels = new Map<string, State>();
    for (const [link, states] of this.byLink) {
      const state = latest(states, t);
      if (state !== undefined) {
        levels.set(link, state);
      }
    }
    return levels;
  }
}
