// Data paths in a file: a datum, an element, an element's field.

import type { Place } from "./protocol";

/** Returns a unique id for a data path. */
export function placeId({ name, key, within = [] }: Place): string {
  const step = (name: string, key: string | undefined): string => (key === undefined ? name : `${name}\u0001${key}`);
  // The server sends an empty key for the container of a field.
  return [step(name, key), ...within.map(({ name, key }) => step(name, key === "" ? undefined : key))].join("\u0002");
}

/** Returns the container without its element's key. */
export function containerOf({ name, key, within = [] }: Place): Place {
  const last = within.at(-1);
  return last === undefined ? { name } : { name, ...(key !== undefined && { key }), within: [...within.slice(0, -1), { name: last.name }] };
}

/** Returns an element of a container. */
export function elementOf(container: Place, key: string): Place {
  const { within = [] } = container;
  const last = within.at(-1);
  return last === undefined ? { name: container.name, key } : { ...container, within: [...within.slice(0, -1), { name: last.name, key }] };
}

/** Returns the container with an element's field. */
export function fieldOf(element: Place, name: string): Place {
  return { ...element, within: [...(element.within ?? []), { name }] };
}

/** Formats the key as a program writes it: `[2]`, `["left"]`. */
export function subscript(key: string, isCollection: boolean): string {
  return isCollection ? `[${JSON.stringify(key)}]` : `[${key}]`;
}

/** Returns an array's keys in order: `0`, `1`, or `0,0`, `0,1`, … */
export function arrayKeys(size: readonly number[]): string[] {
  return size.reduce<string[]>((heads, length) => heads.flatMap((head) => Array.from({ length }, (_, index) => (head === "" ? String(index) : `${head},${index}`))), [""]);
}
