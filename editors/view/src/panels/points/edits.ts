// Changed values of points, until they are saved.

import type * as wire from "../../wire";
import type { LengthUnit } from "../shared/lengths";

export const COORDINATES = ["x", "y", "z", "rx", "ry", "rz"] as const;

export type PointName = wire.PointName;

/** Formats the name as a program writes it: `pPick`, `pPick[2]`, `pPick["left"]`. */
export function pointText({ name, key }: PointName): string {
  return key === null ? name : /^\d+$/.test(key) ? `${name}[${key}]` : `${name}[${JSON.stringify(key)}]`;
}

export function samePoint(left: PointName, right: PointName): boolean {
  return left.name === right.name && left.key === right.key;
}

/** Number of decimals in fields, as on controllers. */
const DIGITS = 3;

/** Formats values of the application for fields: at most 3 decimals, of lengths in inches 4. */
export function fieldTexts(trsf: readonly number[], unit: LengthUnit): string[] {
  return COORDINATES.map((_, index) => fieldText(trsf[index] ?? 0, index < 3, unit));
}

/** Formats a value of the application for a field. */
export function fieldText(value: number, isLength: boolean, unit: LengthUnit): string {
  return String(Number(value.toFixed(DIGITS + (isLength ? unit.decimals : 0))) + 0);
}

/** Returns the name of a coordinate with its unit, unless that is mm or degrees. */
export function coordinateTitle(index: number, unit: LengthUnit): string {
  const name = COORDINATES[index] ?? "";
  return index < 3 && unit.mm !== 1 ? `${name} (${unit.short})` : name;
}

/**
 * Parses the values of fields. A field that was not edited keeps its exact value. For an invalid field, returns its
 * name.
 */
export function editedTrsf(texts: readonly string[], before: readonly number[], unit: LengthUnit): { trsf: number[] } | { wrong: string } {
  const trsf: number[] = [];
  for (const [index, name] of COORDINATES.entries()) {
    const [text, old] = [texts[index] ?? "", before[index] ?? 0];
    const value = text === fieldText(old, index < 3, unit) ? old : Number(text.trim().replace(",", ".") || NaN);
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
