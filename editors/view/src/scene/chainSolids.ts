// Solids along the chain of links, for an arm whose description has no capsules.

import { type BufferGeometry, CylinderGeometry, LatheGeometry, SphereGeometry, Vector2, Vector3 } from "three";
import { armLength, floorHeight, type StandingArm } from "../kinematics";
import { frameOf } from "../panels/pendant/pose";
import type { Look } from "./palette";
import { coloured, rod } from "./three";

export class ChainSolids {
  private readonly radii: readonly number[];

  constructor(private readonly arm: StandingArm, private readonly look: Look) {
    const length = armLength(arm);
    this.radii = arm.links.map((_, index) => length * (0.088 - (0.054 * index) / Math.max(arm.links.length - 1, 1)));
  }

  pedestal(): BufferGeometry[] {
    const { arm } = this;
    const radius = this.radii[0] ?? 50;
    const floor = floorHeight(arm);
    const height = Math.max(frameOf(arm.links[0]?.offset ?? []).position[2] - floor, radius);
    const outline = [[0, 0], [1.75, 0], [1.75, 0.16], [1.3, 0.24], [1.15, 0.6]].map(([x = 0, y = 0]) => new Vector2(x * radius, y * radius));
    outline.push(new Vector2(radius * 1.08, Math.max(height - radius * 0.55, radius * 0.7)), new Vector2(0, Math.max(height - radius * 0.55, radius * 0.7)));
    return [coloured(new LatheGeometry(outline, 48).rotateX(Math.PI / 2).translate(0, 0, floor), this.look.joint)];
  }

  /** Returns the joint of a link, and its body up to the next joint. */
  link(index: number): BufferGeometry[] {
    const { arm, radii } = this;
    const radius = radii[index] ?? 30;
    const axis = new Vector3(...(arm.links[index]?.axis ?? [0, 0, 1]));
    const [x, y, z] = frameOf(arm.links[index + 1]?.offset ?? arm.flange).position;
    const next = new Vector3(x, y, z);
    const isAlong = next.length() < 1 || next.clone().cross(axis).length() < next.length() * 0.2;
    const half = axis.clone().multiplyScalar(radius * (isAlong ? 0.55 : 1.12));
    const ring = half.clone().multiplyScalar(isAlong ? 0.3 : 0.82);
    const cap = half.clone().multiplyScalar(1.04);
    const parts = [
      coloured(rod(half.clone().negate(), half, radius, radius), this.look.body),
      coloured(rod(ring.clone().negate(), ring.clone().multiplyScalar(isAlong ? 1 : -0.8), radius * 1.03, radius * 1.03), this.look.accent),
    ];
    if (!isAlong) {
      parts.push(coloured(rod(cap.clone().negate(), cap, radius * 0.78, radius * 0.78), this.look.joint));
    }
    if (next.length() > radius * 0.5) {
      const end = (radii[index + 1] ?? radius * 0.8) * 0.92;
      parts.push(
        coloured(rod(new Vector3(), next, radius * 0.86, end), this.look.body),
        coloured(new SphereGeometry(end, 32, 20).translate(x, y, z), this.look.body),
      );
    }
    return parts;
  }

  /** Returns the disc at the flange, in the frame of the flange. */
  flange(): BufferGeometry[] {
    const radius = (this.radii.at(-1) ?? 30) * 0.9;
    return [coloured(new CylinderGeometry(radius, radius, radius * 0.35, 40).rotateX(Math.PI / 2).translate(0, 0, -radius * 0.18), this.look.joint)];
  }
}
