// Rows of a table: data, and below them their expanded elements and fields.

import { arrayKeys, containerOf, elementOf, fieldOf, placeId, subscript } from "./place";
import type { Column, DataType, Datum, Place, Value } from "./protocol";

export interface Row {
  /** Constant as long as the data path exists. */
  id: string;
  kind: "datum" | "element" | "field";
  depth: number;
  label: string;
  /** Path of the container if the row has one that can be resized, otherwise of the element. */
  container: Place;
  /** Element whose values the row shows; undefined for a container with several elements. */
  element: Place | undefined;
  datum: Datum;
  /** Values of this element that the file contains. */
  value: Value | undefined;
  columns: readonly Column[];
  isExpandable: boolean;
  isExpanded: boolean;
}

export interface Shape {
  typeOf: (name: string) => DataType | undefined;
  isExpanded: (id: string) => boolean;
  /** Returns the visible elements of a container. */
  shownKeys?: (datum: Datum, container: Place, keys: readonly string[]) => readonly string[];
}

/** Returns the keys of all elements. */
export function keysOf({ container, size, values }: Datum): string[] {
  return container === "collection" ? values.map(({ key }) => key) : arrayKeys(size);
}

/** Whether a container always has exactly one element, which shares its row. */
export function isScalar({ container, size }: Datum): boolean {
  return container === "array" && size.every((length) => length === 1);
}

export function rowsOf(data: readonly Datum[], shape: Shape): Row[] {
  return data.flatMap((datum) => containerRows(datum, { name: datum.name }, "datum", 0, shape));
}

function containerRows(datum: Datum, container: Place, kind: "datum" | "field", depth: number, shape: Shape): Row[] {
  const scalarKey = isScalar(datum) ? keysOf(datum)[0] : undefined;
  const element = scalarKey === undefined ? undefined : elementOf(container, scalarKey);
  const value = datum.values.find(({ key }) => key === scalarKey);
  const id = placeId(container);
  const type = shape.typeOf(datum.type);
  const fields = fieldsOf(value, type);
  const isExpandable = element === undefined ? datum.size.every((length) => length > 0) : fields.length > 0;
  const isExpanded = isExpandable && shape.isExpanded(id);
  const row: Row = { id, kind, depth, label: datum.name, container, element, datum, value, columns: type?.columns ?? [], isExpandable, isExpanded };
  if (!isExpanded) {
    return [row];
  }
  return [row, ...(element === undefined ? elementRows(datum, container, depth + 1, shape) : fieldRows(fields, element, depth + 1, shape))];
}

function elementRows(datum: Datum, container: Place, depth: number, shape: Shape): Row[] {
  const values = new Map(datum.values.map((value) => [value.key, value]));
  const keys = keysOf(datum);
  const type = shape.typeOf(datum.type);
  return (shape.shownKeys?.(datum, container, keys) ?? keys).flatMap((key) => {
    const element = elementOf(container, key);
    const value = values.get(key);
    const id = placeId(element);
    const fields = fieldsOf(value, type);
    const isExpandable = fields.length > 0;
    const isExpanded = isExpandable && shape.isExpanded(id);
    const label = subscript(key, datum.container === "collection");
    const row: Row = { id, kind: "element", depth, label, container, element, datum, value, columns: type?.columns ?? [], isExpandable, isExpanded };
    return isExpanded ? [row, ...fieldRows(fields, element, depth + 1, shape)] : [row];
  });
}

function fieldRows(fields: readonly Datum[], element: Place, depth: number, shape: Shape): Row[] {
  return fields.flatMap((field) => containerRows(field, fieldOf(element, field.name), "field", depth, shape));
}

/** Returns the fields of a value: the fields in the file, then the other fields of the type. */
function fieldsOf(value: Value | undefined, type: DataType | undefined): readonly Datum[] {
  const written = value?.fields ?? [];
  const missing = (type?.fields ?? []).filter(({ name }) => !written.some((field) => field.name === name));
  return [...written, ...missing.map((field): Datum => ({ ...field, access: "private", values: [] }))];
}

/** Returns the key of the element that a row shows. */
export function keyOf({ element }: Row): string | undefined {
  return element === undefined ? undefined : (element.within?.at(-1) ?? element).key;
}

/** Returns the rows that must be expanded so that a data path is visible. */
export function rowsAbove(place: Place): string[] {
  const above: string[] = [];
  const { name, key, within = [] } = place;
  if (key !== undefined) {
    above.push(placeId({ name }));
  }
  within.forEach((step, index) => {
    const path = { name, ...(key !== undefined && { key }), within: within.slice(0, index) };
    above.push(placeId(path), placeId(containerOf(path)));
    if (step.key !== undefined) {
      above.push(placeId({ ...path, within: [...within.slice(0, index), { name: step.name }] }));
    }
  });
  return above;
}
