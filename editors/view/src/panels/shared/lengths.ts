// Length unit of the application. Poses, samples and the picture are in mm; texts and fields have the length unit.

import type * as wire from "../../wire";
import { fixed } from "./fixed";

export interface LengthUnit {
  /** Unit after a number. */
  short: string;
  /** Unit in a sentence. */
  long: string;
  /** Number of mm. */
  mm: number;
  /** Number of decimals in addition to the decimals in mm. */
  decimals: number;
}

export const MILLIMETRES: LengthUnit = { short: "mm", long: "millimetres", mm: 1, decimals: 0 };
export const INCHES: LengthUnit = { short: "in", long: "inches", mm: 25.4, decimals: 1 };

/** Returns the application's length unit. Runs of earlier versions have none. */
export function unitOf(scene: { lengthUnit?: wire.LengthUnit } | undefined): LengthUnit {
  return scene?.lengthUnit === "inch" ? INCHES : MILLIMETRES;
}

/** Formats a length in mm as a number of units. `digits` is the number of decimals for mm. */
export function lengthFigure(mm: number, digits: number, unit: LengthUnit): string {
  return fixed(mm / unit.mm, digits + unit.decimals);
}

/** Formats a length in mm with its unit. `digits` is the number of decimals for mm. */
export function lengthText(mm: number, digits: number, unit: LengthUnit): string {
  return `${lengthFigure(mm, digits, unit)} ${unit.short}`;
}

/** Formats a pose in mm and degrees, with lengths in the unit. */
export function poseTexts(pose: readonly number[], digits: number, unit: LengthUnit): string[] {
  return pose.map((part, index) => (index < 3 ? lengthFigure(part, digits, unit) : fixed(part, digits)));
}

/** Formats a joint position in degrees and mm, with linear axes in the unit. */
export function jointTexts(joints: readonly number[], axes: readonly { isLinear: boolean }[], digits: number, unit: LengthUnit): string[] {
  return joints.map((joint, axis) => (axes[axis]?.isLinear === true ? lengthFigure(joint, digits, unit) : fixed(joint, digits)));
}
