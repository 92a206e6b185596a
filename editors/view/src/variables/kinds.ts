// Storage and passing of a parameter as a single choice.

import type { Container, Parameter, Passing } from "./messages";

type Shape = Pick<Parameter, "container" | "dimensions" | "passing">;

const shape = (container: Container, passing: Passing, dimensions = 1): Shape => ({ container, dimensions, passing });

/** Choices by name. */
const KINDS: Record<string, Shape> = {
  "value": shape("element", "value"),
  "reference": shape("element", "reference"),
  "array []": shape("array", "reference"),
  "array [,]": shape("array", "reference", 2),
  "array [,,]": shape("array", "reference", 3),
  "collection": shape("collection", "reference"),
};

/**
 * Returns the choices in a program. A program of s5 or s6 does not distinguish an element by reference from an array.
 */
export function kinds(isOld: boolean): string[] {
  return isOld ? ["value", "reference"] : Object.keys(KINDS);
}

export function kindOf({ container, dimensions, passing }: Shape, isOld: boolean): string {
  if (isOld) {
    return passing;
  }
  const same = (kind: Shape): boolean => kind.container === container && kind.dimensions === dimensions && kind.passing === passing;
  return Object.entries(KINDS).find(([, kind]) => same(kind))?.[0] ?? passing;
}

export function shapeOf(kind: string): Shape {
  return KINDS[kind] ?? shape("element", "value");
}
