// Computes link poses from joints.

import { add, aroundAxis, composed, type Frame, frameOf, multiplied, turned, type Vector } from "./panels/pendant/pose";
import type { Scene } from "./protocol";

export interface Chain {
  axes: readonly { isLinear: boolean; min: number; max: number }[];
  links: readonly { offset: readonly number[]; axis: readonly number[] }[];
  flange: readonly number[];
}

/** Arm with its mounting face. */
export type StandingArm = Chain & Pick<Scene["arm"], "height" | "capsules">;

export interface ArmFrames {
  /** Frames of the links after their joints' movement. */
  links: Frame[];
  flange: Frame;
}

/** Returns the frames for an arm, in the frame to which `base` is relative. */
export function armFrames(arm: Chain, base: Frame, joints: readonly number[]): ArmFrames {
  let at = base;
  const links = arm.links.map(({ offset, axis: [x = 0, y = 0, z = 1] }, index) => {
    at = moved(composed(at, frameOf(offset)), [x, y, z], joints[index] ?? 0, arm.axes[index]?.isLinear ?? false);
    return at;
  });
  return { links, flange: composed(at, frameOf(arm.flange)) };
}

function moved(at: Frame, axis: Vector, value: number, isLinear: boolean): Frame {
  return isLinear
    ? { ...at, position: add(at.position, turned(at.rotation, axis), value) }
    : { ...at, rotation: multiplied(at.rotation, aroundAxis(axis, value)) };
}

/** Pedestal height of Stäubli arms as a fraction of the arm length. */
const PEDESTAL = 0.4;

/**
 * Returns the height of the floor below the base of an arm. The origin of `world` is in the second axis of most arms:
 * the mounting face is `height` below it, or, where the height is unknown, the lowest point of the base's capsules.
 */
export function floorHeight(arm: StandingArm): number {
  const { height = 0, capsules = [] } = arm;
  const [, , z = 0] = arm.links[0]?.offset ?? [];
  if (z > 1) {
    return 0;
  }
  if (height > 0) {
    return -height;
  }
  const ends = capsules[0]?.map(({ from, to, radius }) => Math.min(from[2] ?? 0, to[2] ?? 0) - radius);
  return ends === undefined ? -PEDESTAL * armLength(arm) : Math.min(...ends);
}

/** Returns the length of the stretched arm without its pedestal, which scales the drawing. */
export function armLength(arm: Chain): number {
  const offsets = [...arm.links.slice(1).map(({ offset }) => offset), arm.flange];
  return Math.max(100, offsets.reduce((sum, [x = 0, y = 0, z = 0]) => sum + Math.hypot(x, y, z), 0));
}
