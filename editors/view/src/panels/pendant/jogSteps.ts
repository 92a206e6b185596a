// Targets of jogging: by joint, and along or around the axes of a frame.

import type { LengthUnit } from "../shared/lengths";
import { type ArmChain, flangeAt, jointsNear, type Refusal } from "./armModel";
import { add, aroundAxis, composed, type Frame, inverse, multiplied, scaled, turned, type Vector } from "./pose";

/** Step size in mm, or in degrees. */
export interface JogStep {
  length: number;
  angle: number;
}

/** Angles of the available steps, in degrees, and their lengths in mm or inches. */
const ANGLES = [0.1, 1, 5, 10, 30] as const;
const INCH_LENGTHS = [0.005, 0.05, 0.2, 0.5, 1] as const;

/** Index of a new page's step. */
export const FIRST_STEP = 2;

/** Returns the available steps in the length unit. */
export function stepsIn(unit: LengthUnit): (JogStep & { text: string })[] {
  return ANGLES.map((angle, index) => {
    const length = unit.mm === 1 ? angle : INCH_LENGTHS[index] ?? 1;
    return { length: length * unit.mm, angle, text: `${length} ${unit.short}, ${angle}°` };
  });
}

/** Time between two steps while a button is held, in ms. */
export const REPEAT = 150;

/** A held button adds a step only while at most this number of steps remains, so that the arm stops soon after the release. */
const AHEAD = 2;

const AXES: readonly Vector[] = [[1, 0, 0], [0, 1, 0], [0, 0, 1]];

/** Target of a step, or the reason why no step is possible; `isArrival` if the arm is already at its destination. */
export type JogTarget = { joints: number[] } | (Refusal & { isArrival?: boolean });

/** Whether at most `AHEAD` steps remain, so that another step may be added. */
export function mayContinue(present: readonly number[], target: readonly number[], start: readonly number[]): boolean {
  return target.every((joint, axis) => {
    const way = Math.abs(joint - (start[axis] ?? 0));
    return Math.abs(joint - (present[axis] ?? 0)) <= Math.max(AHEAD * way, 1e-6);
  });
}

/** Returns the target of a step by one axis in degrees or mm, at most to its limit. */
export function jointStep(arm: ArmChain, joints: readonly number[], axis: number, step: number): JogTarget {
  const limits = arm.axes[axis];
  const present = joints[axis];
  if (limits === undefined || present === undefined) {
    return { refusal: `The arm has no axis ${axis + 1}.` };
  }
  const target = Math.min(limits.max, Math.max(limits.min, present + step));
  if (Math.abs(target - present) < 1e-9) {
    return { refusal: `Axis ${axis + 1} is at its limit.` };
  }
  return { joints: joints.map((joint, at) => (at === axis ? target : joint)) };
}

/** Cartesian step. Directions 0 to 2 are along x, y, z, and 3 to 5 around x, y, z. */
export interface CartesianStep {
  direction: number;
  /** Length in mm, or angle in degrees. */
  step: number;
  /** Frame in world along whose axes the step is; `undefined` for the tool's axes. */
  frame: Frame | undefined;
  base: Frame;
  tool: Frame;
}

/** Returns the joints after a step of the tool centre point. */
export function cartesianStep(arm: ArmChain, joints: readonly number[], way: CartesianStep): JogTarget {
  const present = composed(way.base, composed(flangeAt(arm, joints), way.tool));
  const axes = way.frame ?? present;
  const direction = turned(axes.rotation, AXES[way.direction % 3] ?? [1, 0, 0]);
  const target: Frame = way.direction < 3
    ? { ...present, position: add(present.position, scaled(direction, way.step)) }
    : { ...present, rotation: multiplied(aroundAxis(direction, way.step), present.rotation) };
  return jointsNear(arm, joints, composed(inverse(way.base), target), way.tool);
}

/** Largest step towards a joint position, in degrees or mm of the axis with the longest way. */
const GO_STEP = 5;

/** Returns a function that computes the next step towards a target, along a straight line in joint space. */
export function goStep(target: readonly number[]): (joints: readonly number[]) => JogTarget {
  return (joints) => {
    const ways = target.map((joint, axis) => joint - (joints[axis] ?? 0));
    const longest = Math.max(0, ...ways.map(Math.abs));
    if (longest < 1e-6) {
      return { refusal: "The arm is there.", isArrival: true };
    }
    const factor = Math.min(1, GO_STEP / longest);
    return { joints: target.map((joint, axis) => (factor === 1 ? joint : (joints[axis] ?? 0) + factor * (ways[axis] ?? 0))) };
  };
}

/** Returns the relative position of a value between its limits, from 0 to 1. */
export function fraction(value: number, min: number, max: number): number {
  return max > min ? Math.min(1, Math.max(0, (value - min) / (max - min))) : 0;
}
