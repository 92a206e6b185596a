// Space that the flange of an arm reaches: its outline in a plane, rotated around the first axis.

import { DoubleSide, LatheGeometry, Mesh, MeshBasicMaterial, Vector2 } from "three";
import { armFrames, type Chain } from "../kinematics";
import { IDENTITY, type Frame } from "../panels/pendant/pose";
import { matrixOf } from "./three";

const STEPS = 25;
const DIRECTIONS = 72;

/** Whether the first axis rotates around the vertical of the base. */
export function hasReach({ axes, links }: Chain): boolean {
  return axes[0]?.isLinear === false && Math.abs(links[0]?.axis[2] ?? 0) > 0.99;
}

/** Returns the outline of the reach as distances from the first axis and heights, from the bottom up. */
export function reachOutline(arm: Chain): [distance: number, height: number][] {
  const centre = arm.links[0]?.offset[2] ?? 0;
  const far = new Array<number>(DIRECTIONS + 1).fill(0);
  for (const joints of postures(arm)) {
    const [x, y, z] = armFrames(arm, IDENTITY, joints).flange.position;
    const [distance, height] = [Math.hypot(x, y), z - centre];
    const direction = Math.round((Math.atan2(distance, -height) / Math.PI) * DIRECTIONS);
    far[direction] = Math.max(far[direction] ?? 0, Math.hypot(distance, height));
  }
  return far.map((length, index) => {
    const angle = (index / DIRECTIONS) * Math.PI;
    return [length * Math.sin(angle), centre - length * Math.cos(angle)];
  });
}

/**
 * Returns joint positions over the limits of the second, third and fifth axis. The other axes hardly change the
 * distance.
 */
function* postures({ axes }: Chain): Generator<number[]> {
  const values = (axis: number, steps: number): number[] => {
    const { min, max } = axes[axis] ?? { min: 0, max: 0 };
    return Array.from({ length: steps }, (_, step) => min + ((max - min) * step) / (steps - 1));
  };
  for (const second of values(1, STEPS * 3)) {
    for (const third of values(2, STEPS)) {
      for (const fifth of axes.length > 5 ? [0, ...values(4, 5)] : [0]) {
        yield axes.map((_, axis) => [0, second, third, 0, fifth][axis] ?? 0);
      }
    }
  }
}

export function reachShape(arm: Chain, base: Frame): Mesh {
  const outline = reachOutline(arm).map(([distance, height]) => new Vector2(distance, height));
  const { min, max } = arm.axes[0] ?? { min: -180, max: 180 };
  const [start, turn] = [min * (Math.PI / 180), Math.min(max - min, 360) * (Math.PI / 180)];
  // The lathe rotates around y from z towards x; after the rotation to z up it starts at -y.
  const geometry = new LatheGeometry(outline, 72, start + Math.PI / 2, turn).rotateX(Math.PI / 2);
  const material = new MeshBasicMaterial({ color: 0x56b4e9, transparent: true, opacity: 0.13, side: DoubleSide, depthWrite: false });
  const mesh = new Mesh(geometry, material);
  mesh.applyMatrix4(matrixOf(base));
  mesh.renderOrder = 3;
  return mesh;
}
