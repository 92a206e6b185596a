// Inverse kinematics: computes the joints for a pose near the present pose. The chain of links is part of the scene.

import type * as wire from "../../wire";
import { add, aroundAxis, composed, cross, frameOf, inverse, multiplied, type Frame, rotationVector, transposed, turned, type Vector } from "./pose";

export type ArmChain = Pick<wire.ArmChain, "links" | "flange"> & { axes: readonly Pick<wire.Axis, "isLinear" | "min" | "max">[] };

interface Solution {
  joints: number[];
}

export interface Refusal {
  refusal: string;
}

const ITERATIONS = 60;
/** Weight of orientation errors: one degree counts as this number of mm. */
const MM_PER_DEGREE = 5;
const CLOSE = { mm: 0.005, degrees: 0.001 };
const DEGREE = Math.PI / 180;

/** Returns the frames of the axes before their rotation, and the flange. */
function chain(arm: ArmChain, joints: readonly number[]): { axes: { at: Frame; axis: Vector }[]; flange: Frame } {
  let at = frameOf([]);
  const axes = arm.links.map(({ offset, axis: [x = 0, y = 0, z = 1] }, index) => {
    at = composed(at, frameOf(offset));
    const found = { at, axis: turned(at.rotation, [x, y, z]) };
    const value = joints[index] ?? 0;
    const isLinear = arm.axes[index]?.isLinear ?? false;
    at = isLinear
      ? { ...at, position: add(at.position, found.axis, value) }
      : { ...at, rotation: multiplied(at.rotation, aroundAxis([x, y, z], value)) };
    return found;
  });
  return { axes, flange: composed(at, frameOf(arm.flange)) };
}

/** Returns the flange pose in the frame of the base. */
export function flangeAt(arm: ArmChain, joints: readonly number[]): Frame {
  return chain(arm, joints).flange;
}

/** Returns the joints near `start` at which `tool` has the pose `target` in the frame of the base. */
export function jointsNear(arm: ArmChain, start: readonly number[], target: Frame, tool: Frame): Solution | Refusal {
  const wanted = composed(target, inverse(tool));
  let joints = arm.axes.map((_, axis) => start[axis] ?? 0);
  for (let round = 0; round < ITERATIONS; round += 1) {
    const { axes, flange } = chain(arm, joints);
    const way = add(wanted.position, flange.position, -1);
    const turn = rotationVector(multiplied(wanted.rotation, transposed(flange.rotation)));
    if (Math.hypot(...way) < CLOSE.mm && Math.hypot(...turn) < CLOSE.degrees) {
      return withinLimits(arm, joints);
    }
    const error = [...way, ...turn.map((angle) => angle * MM_PER_DEGREE)];
    const columns = axes.map(({ at, axis }, index) => column(axis, at, flange, arm.axes[index]?.isLinear ?? false));
    const change = dampedStep(columns, error);
    joints = joints.map((joint, axis) => joint + (change[axis] ?? 0));
  }
  return { refusal: "The arm cannot move there: the position is out of reach, or the arm is at a singularity." };
}

/** Returns the movement of the flange per degree or millimetre of an axis. */
function column(axis: Vector, at: Frame, flange: Frame, isLinear: boolean): number[] {
  if (isLinear) {
    return [...axis, 0, 0, 0];
  }
  const way = cross(axis, add(flange.position, at.position, -1)).map((part) => part * DEGREE);
  return [...way, ...axis.map((part) => part * MM_PER_DEGREE)];
}

/** Returns the damped least-squares solution: J^T (J J^T + d I)^-1 e. */
function dampedStep(columns: number[][], error: number[]): number[] {
  const rows = error.map((_, row) => columns.map((values) => values[row] ?? 0));
  const product = (left: readonly number[], right: readonly number[]): number => left.reduce((sum, value, at) => sum + value * (right[at] ?? 0), 0);
  const matrix = rows.map((left, row) => rows.map((right, at) => product(left, right) + (row === at ? 1e-3 : 0)));
  const factors = solved(matrix, error);
  return columns.map((values) => product(values, factors));
}

/** Solves a system of linear equations by elimination. The matrix is positive definite. */
function solved(matrix: number[][], right: number[]): number[] {
  const rows = matrix.map((row, at) => [...row, right[at] ?? 0]);
  rows.forEach((pivot, at) => {
    const divisor = pivot[at] ?? 1;
    pivot.forEach((value, column) => (pivot[column] = value / divisor));
    rows.forEach((other, index) => {
      const factor = other[at] ?? 0;
      if (index !== at && factor !== 0) {
        other.forEach((value, column) => (other[column] = value - factor * (pivot[column] ?? 0)));
      }
    });
  });
  return rows.map((row) => row.at(-1) ?? 0);
}

function withinLimits(arm: ArmChain, joints: number[]): Solution | Refusal {
  const outside = arm.axes.findIndex(({ min, max }, axis) => (joints[axis] ?? 0) < min || (joints[axis] ?? 0) > max);
  return outside < 0 ? { joints } : { refusal: `Axis ${outside + 1} would leave its limits.` };
}
