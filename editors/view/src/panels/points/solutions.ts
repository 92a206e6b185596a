// Joint positions that reach a point, from the response of `solve`.

import type * as wire from "../../wire";
import type { Answer } from "../shared/cell";
import { jointTexts, type LengthUnit } from "../shared/lengths";

export type ArmSolution = wire.ArmSolution;

/** Returns the solutions in a response. */
export function solutionsOf(answer: Answer): ArmSolution[] {
  const solutions = answer["solutions"];
  return Array.isArray(solutions) ? solutions.filter(isSolution) : [];
}

function isSolution(value: unknown): value is ArmSolution {
  return typeof value === "object" && value !== null && "joints" in value && "isChosen" in value;
}

/** Returns the index of the solution to which the arm moves first: the solution that `movej` uses, otherwise the first reachable one. */
export function firstChoice(solutions: readonly ArmSolution[]): number {
  const chosen = solutions.findIndex(({ isChosen }) => isChosen);
  return chosen >= 0 ? chosen : solutions.findIndex(({ joints }) => joints !== null);
}

/** Text of a solution: its joints, or the reason why there are none. */
export function solutionText({ joints, reason }: ArmSolution, axes: readonly { isLinear: boolean }[], unit: LengthUnit): string {
  return joints === null ? reason ?? "out of reach" : jointTexts(joints, axes, 1, unit).join("  ");
}
