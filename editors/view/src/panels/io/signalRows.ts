// Rows of the signal table: by board, filtered.

import type * as wire from "../../wire";

export type SignalInfo = Omit<wire.SignalInfo, "description">;

export type SignalState = Omit<wire.SignalState, "link">;

/** Heading of a board, or a signal. */
export type SignalRow = { board: string; count: number } | { signal: SignalInfo };

export interface SignalFilter {
  text: string;
  direction: "all" | "input" | "output";
  /** Whether to show only signals that differ from their hardware: locked, simulated, protected or faulty. */
  isMarkedOnly: boolean;
}

const BY_NUMBER = new Intl.Collator("en", { numeric: true });

/** Returns the last part of a link, which is the address of the signal on its board. */
export function addressOf(link: string): string {
  return link.slice(link.lastIndexOf("\\") + 1);
}

/** Returns the names of a signal's data, or its address if it has none. */
export function nameOf({ link, names }: SignalInfo): string {
  return names.length === 0 ? addressOf(link) : names.join(", ");
}

/** Returns the address, if it is not the name, and the direction. */
export function placeOf({ link, names, direction }: SignalInfo): string {
  return `${names.length === 0 ? "" : `${addressOf(link)} `}${direction === "input" ? "in" : "out"}`;
}

/** Returns the largest number of characters in a name with its address and direction. */
export function longestName(signals: readonly SignalInfo[]): number {
  return signals.reduce((longest, signal) => Math.max(longest, nameOf(signal).length + placeOf(signal).length + 1), 0);
}

export function boardOf({ board, link }: SignalInfo): string {
  return board || link.slice(0, Math.max(0, link.lastIndexOf("\\"))) || "Other";
}

/** Whether each word of the filter is in the link, the board or a name of the data. */
export function matches(signal: SignalInfo, words: readonly string[]): boolean {
  const text = [signal.link, signal.board, ...signal.names].join("\n").toLowerCase();
  return words.every((word) => text.includes(word));
}

export function wordsOf(text: string): string[] {
  return text.toLowerCase().split(/\s+/).filter((word) => word !== "");
}

export function isMarked(state: SignalState | undefined): boolean {
  return state !== undefined && (state.isLocked || state.isSimulated || state.isProtected || state.fault !== null);
}

/** Sorts the signals once per scene: by board, then inputs and outputs by address. */
export function sorted(signals: readonly SignalInfo[]): SignalInfo[] {
  return signals.toSorted((left, right) => BY_NUMBER.compare(boardOf(left), boardOf(right)) || BY_NUMBER.compare(left.link, right.link));
}

export function rowsOf(signals: readonly SignalInfo[], filter: SignalFilter, stateOf: (link: string) => SignalState | undefined): SignalRow[] {
  const words = wordsOf(filter.text);
  const shown = signals.filter((signal) => (filter.direction === "all" || signal.direction === filter.direction)
    && matches(signal, words) && (!filter.isMarkedOnly || isMarked(stateOf(signal.link))));
  const boards = new Map<string, SignalInfo[]>();
  for (const signal of shown) {
    const board = boardOf(signal);
    const own = boards.get(board);
    if (own === undefined) {
      boards.set(board, [signal]);
    } else {
      own.push(signal);
    }
  }
  return [...boards].flatMap(([board, own]): SignalRow[] => [{ board, count: own.length }, ...own.map((signal) => ({ signal }))]);
}

export function levelText(signal: SignalInfo, value: number): string {
  const number = String(Number(value.toFixed(3)));
  return signal.isDigital ? (value === 0 ? "false" : "true") : signal.unit ? `${number} ${signal.unit}` : number;
}

/** Parses a number; `undefined` if the text is not a number. */
export function numberFrom(text: string): number | undefined {
  const written = text.trim().replace(",", ".");
  const number = Number(written);
  return written === "" || !Number.isFinite(number) ? undefined : number;
}

/** Returns the script keys that set a signal's value. A locked signal accepts values only from its lock. */
export function forceKeys(signal: SignalInfo, value: number, isLocked: boolean): object {
  const level = signal.isDigital ? value !== 0 : value;
  return { [isLocked ? "lock" : "io"]: { [signal.link]: level } };
}
