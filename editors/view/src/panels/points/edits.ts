// Changed values of points, until they are saved.

import type * as wire from "../../wire";

export const COORDINATES = ["x", "y", "z", "rx", "ry", "rz"] as const;

export type PointName = wire.PointName;

/** Formats the name as a program writes it: `pPick`, `pPick[2]`, `pPick["left"]`. */
export function pointText({ name, key }: PointName): string {
  return key === null ? name : /^\d+$/.test(key) ? `${name}[${key}]` : `${name}[${JSON.stringify(key)}]`;
}

export function samePoint(left: PointName, right: PointName): boolean {
  return left.name === right.name && left.key === right.key;
}

/** Formats values for fields: at most 3 decimals, as on controllers. */
export function fieldTexts(trsf: readonly number[]): string[] {
  return COORDINATES.map((_, index) => shortNumber(trsf[index] ?? 0));
}

export function shortNumber(value: number): string {
  return String(Number(value.toFixed(3)) + 0);
}

/**
 * Parses the values of fields. A field that was not edited keeps its exact value. For an invalid field, returns its
 * name.
 */
export function editedTrsf(texts: readonly string[], before: readonly number[]): { trsf: number[] } | { wrong: string } {
  const trsf: number[] = [];
  for (const [index, name] of COORDINATES.entries()) {
    const [text, old] = [texts[index] ?? "", before[index] ?? 0];
    const value = text === shortNumber(old) ? old : Number(text.trim().replace(",", ".") || NaN);
    if (!Number.isFinite(value)) {
      return { wrong: `${name} needs a number, not "${text}".` };
    }
    trsf.push(value);
  }
  return { trsf };
}

/** Formats the fathers of a point up to world: `fPallet in fCell in world`. */
export function fatherText(father: string | null, fathers: ReadonlyMap<string, string | null>): string {
  const chain: string[] = [];
  for (let frame = father; frame !== null && frame !== "world" && !chain.includes(frame); frame = fathers.get(frame) ?? null) {
    chain.push(frame);
  }
  return [...chain, "world"].join(" in ");
}
