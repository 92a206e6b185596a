// Farthest positions that the centre point of a tool reaches: an outline in a plane, rotated around the first axis.

import { DoubleSide, LatheGeometry, Mesh, MeshBasicMaterial, type Scene, Vector2 } from "three";
import type { Chain } from "../kinematics";
import { IDENTITY, type Frame } from "../panels/pendant/pose";
import { ToolPositions } from "../toolPositions";
import { matrixOf } from "./three";

const STEPS = 25;
const DIRECTIONS = 72;

/** Steps of the fifth axis, which points the tool, and of the last axis, which turns a tool that is not on its axis. */
const POINTING_STEPS = 13;
const TURNING_STEPS = 9;

/** Smallest distance of an eccentric tool from the last axis, in mm. */
const BESIDE = 0.1;

/** Whether the first axis rotates around the vertical of the base. */
export function hasReach({ axes, links }: Chain): boolean {
  return axes[0]?.isLinear === false && Math.abs(links[0]?.axis[2] ?? 0) > 0.99;
}

/** Returns the outline of a tool's reach as distances from the first axis and heights, from the bottom up. `tool` is the pose of the centre point on the flange. */
export function reachOutline(arm: Chain, tool: readonly number[]): [distance: number, height: number][] {
  const centre = arm.links[0]?.offset[2] ?? 0;
  const far = new Array<number>(DIRECTIONS + 1).fill(0);
  const positions = new ToolPositions(arm, IDENTITY);
  for (const joints of postures(arm, tool)) {
    const [x, y, z] = positions.at(joints.map((joint) => [joint]), 0, tool);
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
 * Returns joint positions over the limits of the second, third and fifth axis, and of the last axis if the tool is
 * eccentric. The first axis does not change the distance; the fourth axis of six hardly does.
 */
function* postures({ axes }: Chain, [x = 0, y = 0, z = 0]: readonly number[]): Generator<number[]> {
  const values = (axis: number, steps: number): number[] => {
    const { min, max } = axes[axis] ?? { min: 0, max: 0 };
    return Array.from({ length: steps }, (_, step) => min + ((max - min) * step) / (steps - 1));
  };
  const last = axes.length - 1;
  const fifths = last < 5 ? [0] : [0, ...values(4, Math.hypot(x, y, z) > BESIDE ? POINTING_STEPS : 5)];
  const turns = Math.hypot(x, y) > BESIDE ? values(last, TURNING_STEPS) : [0];
  for (const second of values(1, STEPS * 3)) {
    for (const third of values(2, STEPS)) {
      for (const fifth of fifths) {
        for (const turn of turns) {
          yield axes.map((_, axis) => (axis === last ? turn : [0, second, third, 0, fifth][axis] ?? 0));
        }
      }
    }
  }
}

function reachShape(arm: Chain, base: Frame, tool: readonly number[]): Mesh {
  const outline = reachOutline(arm, tool).map(([distance, height]) => new Vector2(distance, height));
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

/** Surface of a tool's reach in the drawing. */
export class ReachSurface {
  private mesh: Mesh | undefined;
  private shown: readonly unknown[] = [];

  constructor(private readonly scene: Scene) {}

  /** Draws the surface of a tool, if the arm or the tool has changed. */
  place(arm: Chain, base: Frame, tool: readonly number[]): void {
    // Poses of the last move's tool have rounding errors.
    const wanted = [arm, ...tool.slice(0, 3).map((part) => part.toFixed(2))];
    if (wanted.length !== this.shown.length || wanted.some((value, index) => value !== this.shown[index])) {
      this.remove();
      this.shown = wanted;
      this.mesh = reachShape(arm, base, tool);
      this.scene.add(this.mesh);
    }
  }

  remove(): void {
    this.mesh?.removeFromParent();
    this.mesh?.geometry.dispose();
    this.mesh = undefined;
    this.shown = [];
  }
}
