// Shape of an arm: one part for the base and for each link. A part is drawn as its file, otherwise as the capsules with
// which distances are computed. An arm without capsules is drawn along its chain.

import { type BufferGeometry, Group, Mesh, MeshStandardMaterial, Plane, Vector3 } from "three";
import { mergeGeometries } from "three/addons/utils/BufferGeometryUtils.js";
import { type ArmFrames, floorHeight } from "../kinematics";
import { frameOf } from "../panels/pendant/pose";
import type { LinkShape, Scene } from "../protocol";
import { ChainSolids } from "./chainSolids";
import { readShape } from "./linkShape";
import type { Look } from "./palette";
import { capsule } from "./solids";
import { matrixOf } from "./three";

type DrawnArm = Pick<Scene["arm"], "axes" | "links" | "flange" | "height" | "capsules" | "shapes">;

export class ArmShape {
  readonly group = new Group();
  private readonly material = new MeshStandardMaterial({ vertexColors: true, roughness: 0.48, metalness: 0.08 });
  private readonly base: Group;
  private readonly links: Group[];
  private readonly flange: Group;

  /** `changed` is called when a shape has been read. */
  constructor(arm: DrawnArm, base: readonly number[], private readonly look: Look, private readonly changed: (fault?: string) => void) {
    const { capsules = [], shapes = [] } = arm;
    const last = arm.links.length;
    const chain = new ChainSolids(arm, look);
    const solids = (part: number): BufferGeometry[] => {
      const isEnd = part === 0 || part === last;
      const drawn = capsules[part]?.flatMap((shape) => (isEnd ? capsule(shape, look.joint) : capsule(shape, look.body, look.accent)));
      return drawn ?? (part === 0 ? chain.pedestal() : chain.link(part - 1));
    };
    this.base = this.part("The base", shapes[0], () => this.mesh(solids(0), this.standing(arm, base)));
    this.links = arm.links.map((_, index) => this.part(`Link ${index + 1}`, shapes[index + 1], () => this.mesh(solids(index + 1))));
    this.flange = new Group();
    if (capsules.length === 0 && !shapes[last]) {
      this.flange.add(this.mesh(chain.flange()));
    }
    this.group.add(this.base, ...this.links, this.flange);
    for (const part of this.group.children) {
      part.matrixAutoUpdate = false;
    }
    this.base.matrix.copy(matrixOf(frameOf(base)));
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

  /** Returns the material of the base. The base's capsule ends below the mounting face, where no distance is computed. */
  private standing(arm: DrawnArm, base: readonly number[]): MeshStandardMaterial {
    const material = this.material.clone();
    const floor = floorHeight(arm) + frameOf(base).position[2];
    material.clippingPlanes = [new Plane(new Vector3(0, 0, 1), -floor)];
    return material;
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

  private mesh(parts: BufferGeometry[], material = this.material): Mesh {
    const mesh = new Mesh(mergeGeometries(parts), material);
    parts.forEach((part) => part.dispose());
    mesh.castShadow = true;
    mesh.receiveShadow = true;
    return mesh;
  }
}
