// The poses of the links of an arm from its joints.

import { add, aroundAxis, composed, type Frame, frameOf, multiplied, turned, type Vector } from "./panels/pendant/pose";

export interface Chain {
  axes: readonly { isLinear: boolean; min: number; max: number }[];
  links: readonly { offset: readonly number[]; axis: readonly number[] }[];
  flange: readonly number[];
}

export interface ArmFrames {
  /** The frame of each link after the movement of its joint. */
  links: Frame[];
  flange: Frame;
}

/** The frames of an arm in the frame in which `base` is written. */
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

/** The part of the arm's length that the pedestals of Stäubli's arms are high. */
const PEDESTAL = 0.4;

/** The height of the floor in `world`, which lies in the second axis of most arms: their data have no height of the base. */
export function floorHeight(arm: Chain): number {
  const [, , z = 0] = arm.links[0]?.offset ?? [];
  return z > 1 ? 0 : -PEDESTAL * armLength(arm);
}

/** The length of the stretched arm without its pedestal, which scales all that is drawn. */
export function armLength(arm: Chain): number {
  const offsets = [...arm.links.slice(1).map(({ offset }) => offset), arm.flange];
  return Math.max(100, offsets.reduce((sum, [x = 0, y = 0, z = 0]) => sum + Math.hypot(x, y, z), 0));
}
