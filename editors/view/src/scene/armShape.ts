// Shape of an arm from its chain of links: one mesh per link.

import { type BufferGeometry, CylinderGeometry, Group, LatheGeometry, Mesh, MeshStandardMaterial, SphereGeometry, Vector2, Vector3 } from "three";
import { mergeGeometries } from "three/addons/utils/BufferGeometryUtils.js";
import { type ArmFrames, armLength, type Chain, floorHeight } from "../kinematics";
import { type Frame, frameOf } from "../panels/pendant/pose";
import type { LinkShape } from "../protocol";
import { readShape } from "./linkShape";
import type { Look } from "./palette";
import { coloured, matrixOf, rod } from "./three";

export class ArmShape {
  readonly group = new Group();
  private readonly material = new MeshStandardMaterial({ vertexColors: true, roughness: 0.48, metalness: 0.08 });
  private readonly links: Group[];
  private readonly flange: Mesh;

  /** `changed` is called when a shape has been read. */
  constructor(private readonly arm: Chain, base: Frame, shapes: readonly (LinkShape | null)[], private readonly look: Look, private readonly changed: (fault?: string) => void) {
    const radii = radiiOf(arm);
    const pedestal = this.part("The base", shapes[0], () => this.mesh(this.pedestal(radii[0] ?? 50)));
    pedestal.applyMatrix4(matrixOf(base));
    this.links = arm.links.map((_, index) => this.part(`Link ${index + 1}`, shapes[index + 1], () => this.mesh(this.link(radii, index))));
    const last = (radii.at(-1) ?? 30) * 0.9;
    this.flange = this.mesh([
      coloured(new CylinderGeometry(last, last, last * 0.35, 40).rotateX(Math.PI / 2).translate(0, 0, -last * 0.18), look.joint),
    ]);
    this.flange.visible = !shapes[arm.links.length];
    this.group.add(pedestal, ...this.links, this.flange);
    for (const part of [...this.links, this.flange]) {
      part.matrixAutoUpdate = false;
    }
  }

  place({ links, flange }: ArmFrames): void {
    links.forEach((frame, index) => this.links[index]?.matrix.copy(matrixOf(frame)));
    this.flange.matrix.copy(matrixOf(flange));
  }

  dispose(): void {
    this.group.removeFromParent();
    this.group.traverse((part) => {
      if (part instanceof Mesh) {
        (part.geometry as BufferGeometry).dispose();
      }
    });
  }

  /** Creates a part with the shape in its file, or as a solid without a file. */
  private part(name: string, shape: LinkShape | null | undefined, solid: () => Mesh): Group {
    const group = new Group();
    if (shape) {
      readShape(shape, this.look.body).then((read) => {
        group.add(read);
        this.changed();
      }, (fault: unknown) => {
        group.add(solid());
        this.changed(`${name} is drawn as a solid, because its file cannot be read: ${fault instanceof Error ? fault.message : String(fault)}`);
      });
    } else {
      group.add(solid());
    }
    return group;
  }

  private mesh(parts: BufferGeometry[]): Mesh {
    const mesh = new Mesh(mergeGeometries(parts), this.material);
    parts.forEach((part) => part.dispose());
    mesh.castShadow = true;
    mesh.receiveShadow = true;
    return mesh;
  }

  private pedestal(radius: number): BufferGeometry[] {
    const { arm } = this;
    const floor = floorHeight(arm);
    const height = Math.max(frameOf(arm.links[0]?.offset ?? []).position[2] - floor, radius);
    const outline = [[0, 0], [1.75, 0], [1.75, 0.16], [1.3, 0.24], [1.15, 0.6]].map(([x = 0, y = 0]) => new Vector2(x * radius, y * radius));
    outline.push(new Vector2(radius * 1.08, Math.max(height - radius * 0.55, radius * 0.7)), new Vector2(0, Math.max(height - radius * 0.55, radius * 0.7)));
    return [coloured(new LatheGeometry(outline, 48).rotateX(Math.PI / 2).translate(0, 0, floor), this.look.joint)];
  }

  /** Returns the joint of a link, and its body up to the next joint. */
  private link(radii: readonly number[], index: number): BufferGeometry[] {
    const { arm } = this;
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
}

function radiiOf(arm: Chain): number[] {
  const length = armLength(arm);
  const count = arm.links.length;
  return arm.links.map((_, index) => length * (0.088 - (0.054 * index) / Math.max(count - 1, 1)));
}
