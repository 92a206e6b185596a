// Places within the data of a file: a datum, an element, a field of an element.

import type { Place } from "./protocol";

/** A text that is different for every place. */
export function placeId({ name, key, within = [] }: Place): string {
  const step = (name: string, key: string | undefined): string => (key === undefined ? name : `${name}\u0001${key}`);
  // The server gives the container of a field an empty key.
  return [step(name, key), ...within.map(({ name, key }) => step(name, key === "" ? undefined : key))].join("\u0002");
}

/** The same container without the key of its element. */
export function containerOf({ name, key, within = [] }: Place): Place {
  const last = within.at(-1);
  return last === undefined ? { name } : { name, ...(key !== undefined && { key }), within: [...within.slice(0, -1), { name: last.name }] };
}

/** The element of a container. */
export function elementOf(container: Place, key: string): Place {
  const { within = [] } = container;
  const last = within.at(-1);
  return last === undefined ? { name: container.name, key } : { ...container, within: [...within.slice(0, -1), { name: last.name, key }] };
}

/** The container of a field of an element. */
export function fieldOf(element: Place, name: string): Place {
  return { ...element, within: [...(element.within ?? []), { name }] };
}

/** The key as a program writes it: `[2]`, `["left"]`. */
export function subscript(key: string, isCollection: boolean): string {
  return isCollection ? `[${JSON.stringify(key)}]` : `[${key}]`;
}

/** The keys of an array in their order: `0`, `1`, or `0,0`, `0,1`, … */
export function arrayKeys(size: readonly number[]): string[] {
  return size.reduce<string[]>((heads, length) => heads.flatMap((head) => Array.from({ length }, (_, index) => (head === "" ? String(index) : `${head},${index}`))), [""]);
}
