// Complete lists after an edit in one row.

import type { Local, LocalEdit, Parameter, ParameterEdit } from "./messages";

export function keptParameters(parameters: readonly Parameter[]): ParameterEdit[] {
  return parameters.map(({ name, type, container, dimensions, passing }, from) => ({ from, name, type, container, dimensions, passing }));
}

export function keptLocals(locals: readonly Local[]): LocalEdit[] {
  return locals.map(({ name, type, size }, from) => ({ from, name, type, size }));
}

/** Returns the list with a changed entry at `index`. */
export function replaced<Entry>(list: Entry[], index: number, change: Partial<Entry>): Entry[] {
  return list.map((entry, at) => (at === index ? { ...entry, ...change } : entry));
}

/** Returns the list with an entry moved to another index; `undefined` if that index does not exist. */
export function moved<Entry>(list: Entry[], index: number, to: number): Entry[] | undefined {
  if (to < 0 || to >= list.length) {
    return undefined;
  }
  const rest = list.filter((_, at) => at !== index);
  return [...rest.slice(0, to), ...list.slice(index, index + 1), ...rest.slice(to)];
}

export function removed<Entry>(list: Entry[], index: number): Entry[] {
  return list.filter((_, at) => at !== index);
}

/** Returns the literal that callers can pass for a new parameter of a type; empty if there is no literal. */
export function literalOf(type: string): string {
  const literals: Record<string, string> = { num: "0", bool: "false", string: '""' };
  return literals[type] ?? "";
}
