// Joint positions that an operator enters as numbers.

import type { ArmChain } from "./armModel";

/** Parses a joint position. The refusal names the first axis that has no number or is outside its limits. */
export function enteredJoints(axes: ArmChain["axes"], texts: readonly string[]): { joints: number[] } | { refusal: string } {
  const joints: number[] = [];
  for (const [index, { isLinear, min, max }] of axes.entries()) {
    const [text, unit] = [texts[index] ?? "", isLinear ? "mm" : "degrees"];
    const value = Number(text.trim().replace(",", ".") || NaN);
    if (!Number.isFinite(value)) {
      return { refusal: `J${index + 1} needs a number, not "${text}".` };
    }
    if (value < min || value > max) {
      return { refusal: `J${index + 1} is ${value}, outside the range from ${min} to ${max} ${unit}.` };
    }
    joints.push(value);
  }
  return { joints };
}
