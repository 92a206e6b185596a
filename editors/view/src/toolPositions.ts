// Positions of the tool centre point for many samples.

import type { Chain } from "./kinematics";
import { type Frame, frameOf, type Rotation, type Vector } from "./panels/pendant/pose";

const DEGREE = Math.PI / 180;

/** Link of the chain: its frame in the previous link, and its axis. */
interface Link {
  offset: Frame;
  axis: Vector;
  isLinear: boolean;
}

/**
 * Computes positions only, from the flange to the base, and without allocation: an hour of motion has 900,000 samples,
 * for which `armFrames` needs several seconds.
 */
export class ToolPositions {
  private readonly links: readonly Link[];
  private readonly flange: Frame;
  /** Position of the present computation. */
  private x = 0;
  private y = 0;
  private z = 0;

  constructor(arm: Chain, private readonly base: Frame) {
    this.links = arm.links.map(({ offset, axis: [x = 0, y = 0, z = 1] }, index) => ({ offset: frameOf(offset), axis: [x, y, z], isLinear: arm.axes[index]?.isLinear ?? false }));
    this.flange = frameOf(arm.flange);
  }

  /** Returns the position of a tool at the joints with this index in the columns of the axes. */
  at(joints: readonly ArrayLike<number>[], index: number, [x = 0, y = 0, z = 0]: readonly number[]): Vector {
    [this.x, this.y, this.z] = [x, y, z];
    this.place(this.flange);
    for (let axis = this.links.length - 1; axis >= 0; axis -= 1) {
      const link = this.links[axis];
      if (link !== undefined) {
        this.move(link, joints[axis]?.[index] ?? 0);
        this.place(link.offset);
      }
    }
    this.place(this.base);
    return [this.x, this.y, this.z];
  }

  /** Moves the position with a joint. */
  private move({ axis: [ax, ay, az], isLinear }: Link, joint: number): void {
    const { x, y, z } = this;
    if (isLinear) {
      this.x += ax * joint;
      this.y += ay * joint;
      this.z += az * joint;
      return;
    }
    const [s, c] = [Math.sin(joint * DEGREE), Math.cos(joint * DEGREE)];
    const along = (ax * x + ay * y + az * z) * (1 - c);
    this.x = x * c + (ay * z - az * y) * s + ax * along;
    this.y = y * c + (az * x - ax * z) * s + ay * along;
    this.z = z * c + (ax * y - ay * x) * s + az * along;
  }

  /** Converts the position from a frame to the frame that contains it. */
  private place({ position, rotation }: Frame): void {
    const { x, y, z } = this;
    const [one, two, three]: Rotation = rotation;
    this.x = one[0] * x + one[1] * y + one[2] * z + position[0];
    this.y = two[0] * x + two[1] * y + two[2] * z + position[1];
    this.z = three[0] * x + three[1] * y + three[2] * z + position[2];
  }
}
