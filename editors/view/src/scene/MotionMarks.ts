// Recorded moves: the path ahead, and the spheres around its blends.

import { Color, DoubleSide, InstancedMesh, Matrix4, MeshBasicMaterial, SphereGeometry } from "three";
import type { CellMotion, QueuedMove } from "../panels/shared/cell";
import { Lines } from "./lines";
import { CORNERS, phaseColour } from "./palette";

/** Largest number of drawn spheres. */
const MOST = 256;

type Corner = Pick<QueuedMove, "target" | "leaveDistance" | "reachDistance">;

export class MotionMarks {
  private readonly way = new Lines({ width: 2.2, dash: 14 });
  private readonly spheres = new InstancedMesh(new SphereGeometry(1, 24, 16), new MeshBasicMaterial({ transparent: true, opacity: 0.22, depthWrite: false, side: DoubleSide }), MOST);
  readonly objects = [this.way.object, this.spheres];
  private placed: CellMotion | undefined;

  constructor() {
    this.spheres.count = 0;
    this.spheres.frustumCulled = false;
  }

  /** Shows or hides the path and the spheres. */
  show(isShown: boolean): void {
    this.way.object.visible = isShown && this.way.segments.count > 0;
    this.spheres.visible = isShown;
  }

  /** Draws the moves if they have changed. */
  place(motion: CellMotion): void {
    if (motion === this.placed) {
      return;
    }
    this.placed = motion;
    this.way.segments.clear();
    for (const { phase, points } of motion.path) {
      const { r, g, b } = new Color(phaseColour(phase));
      points.slice(1).forEach((end, index) => this.way.segments.add(points[index] ?? end, end, [r, g, b]));
    }
    this.way.show();
    const spheres = spheresOf(motion.queue).slice(0, MOST);
    spheres.forEach(({ at: [x = 0, y = 0, z = 0], radius, kind }, index) => {
      this.spheres.setMatrixAt(index, new Matrix4().makeScale(radius, radius, radius).setPosition(x, y, z));
      this.spheres.setColorAt(index, new Color(CORNERS[kind]));
    });
    this.spheres.count = spheres.length;
    this.spheres.instanceMatrix.needsUpdate = true;
    if (this.spheres.instanceColor !== null) {
      this.spheres.instanceColor.needsUpdate = true;
    }
  }
}

/** Returns the spheres in which the arm leaves and reaches the segments between points; if both have the same size, one sphere. */
export function spheresOf(queue: readonly Corner[]): { at: readonly number[]; radius: number; kind: keyof typeof CORNERS }[] {
  return queue.flatMap(({ target, leaveDistance, reachDistance }) => {
    const radii = leaveDistance === reachDistance ? ([["both", leaveDistance]] as const) : ([["leave", leaveDistance], ["reach", reachDistance]] as const);
    return radii.flatMap(([kind, radius]) => (radius !== null && radius > 0 ? [{ at: target, radius, kind }] : []));
  });
}
