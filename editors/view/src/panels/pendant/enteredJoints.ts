// Joint positions that an operator enters as numbers.

import type { LengthUnit } from "../shared/lengths";
import type { ArmChain } from "./armModel";

/**
 * Parses a joint position with linear axes in the length unit. The result is in degrees and mm; the refusal names the
 * first axis that has no number or is outside its limits.
 */
export function enteredJoints(axes: ArmChain["axes"], texts: readonly string[], unit: LengthUnit): { joints: number[] } | { refusal: string } {
  const joints: number[] = [];
  for (const [index, { isLinear, min, max }] of axes.entries()) {
    const text = texts[index] ?? "";
    const entered = Number(text.trim().replace(",", ".") || NaN);
    if (!Number.isFinite(entered)) {
      return { refusal: `J${index + 1} needs a number, not "${text}".` };
    }
    const scale = isLinear ? unit.mm : 1;
    const value = entered * scale;
    if (value < min || value > max) {
      return { refusal: `J${index + 1} is ${entered}, outside the range from ${short(min / scale)} to ${short(max / scale)} ${isLinear ? unit.short : "degrees"}.` };
    }
    joints.push(value);
  }
  return { joints };
}

function short(value: number): number {
  return Number(value.toFixed(4));
}
