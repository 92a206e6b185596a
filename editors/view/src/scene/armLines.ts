// Lines through the arm, which names do not cover.

import type { ArmFrames } from "../kinematics";
import { add, type Frame, turned, type Vector } from "../panels/pendant/pose";
import type { Scene } from "../protocol";

/** Returns the axes of the arm's capsules in world, or without capsules the lines from joint to joint. */
export function armLines(arm: Pick<Scene["arm"], "capsules">, base: Frame, { links, flange }: ArmFrames): (readonly [Vector, Vector])[] {
  const frames = [base, ...links];
  if (arm.capsules === undefined || arm.capsules.length === 0) {
    return [...links, flange].map((end, index) => [frames[index]?.position ?? end.position, end.position]);
  }
  return arm.capsules.flatMap((capsules, part) => capsules.map(({ from, to }) => {
    const frame = frames[part] ?? base;
    return [placed(frame, from), placed(frame, to)] as const;
  }));
}

function placed({ position, rotation }: Frame, [x = 0, y = 0, z = 0]: readonly number[]): Vector {
  return add(position, turned(rotation, [x, y, z]));
}

/** Returns positions on a line, with its ends. */
export function along([start, end]: readonly [Vector, Vector]): Vector[] {
  return [0, 0.25, 0.5, 0.75, 1].map((share) => add(start, [end[0] - start[0], end[1] - start[1], end[2] - start[2]], share));
}
