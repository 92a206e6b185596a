// Arm shape: a part for the base and for each link. A part is drawn as its file, otherwise as the capsules with
// which distances are computed. An arm without capsules is drawn along its chain.

import { type BufferGeometry, Group, Mesh, MeshStandardMaterial, Plane, Vector3 } from "three";
import { mergeGeometries } from "three/addons/utils/BufferGeometryUtils.js";
import { type ArmFrames, floorHeight } from "../kinematics";
import { frameOf } from "../panels/pendant/pose";
import type { LinkShape, Scene } from "../protocol";
import type { Nearness } from "../panels/clearance/encounters";
import { ChainSolids } from "./chainSolids";
import { readShape } from "./linkShape";
import { markNearness } from "./nearness";
import type { Look } from "./palette";
import { capsule } from "./solids";
import { matrixOf } from "./three";

type DrawnArm = Pick<Scene["arm"], "axes" | "links" | "flange" | "height" | "capsules" | "shapes">;

export class ArmShape {
  readonly group = new Group();
  /** Materials of the base and the links, for parts without a file. */
  private readonly materials: MeshStandardMaterial[];
  private readonly base: Group;
  private readonly links: Group[];
  private readonly flange: Group;
  private isDisposed = false;

  /** `changed` is called when a shape has been read. */
  constructor(arm: DrawnArm, base: readonly number[], private readonly look: Look, private readonly changed: (fault?: string) => void) {
    const { capsules = [], shapes = [] } = arm;
    this.materials = [null, ...arm.links].map(() => new MeshStandardMaterial({ vertexColors: true, roughness: 0.48, metalness: 0.08 }));
    const last = arm.links.length;
    const chain = new ChainSolids(arm, look);
    const solids = (part: number): BufferGeometry[] => {
      const isEnd = part === 0 || part === last;
      const drawn = capsules[part]?.flatMap((shape) => (isEnd ? capsule(shape, look.joint) : capsule(shape, look.body, look.accent)));
      return drawn ?? (part === 0 ? chain.pedestal() : chain.link(part - 1));
    };
    this.base = this.part("The base", shapes[0], () => this.mesh(solids(0), 0));
    this.links = arm.links.map((_, index) => this.part(`Link ${index + 1}`, shapes[index + 1], () => this.mesh(solids(index + 1), index + 1)));
    this.flange = new Group();
    if (capsules.length === 0 && !shapes[last]) {
      this.flange.add(this.mesh(chain.flange(), last));
    }
    this.group.add(this.base, ...this.links, this.flange);
    for (const part of this.group.children) {
      part.matrixAutoUpdate = false;
    }
    this.base.matrix.copy(matrixOf(frameOf(base)));
    this.clipBase(arm, base);
  }

  place({ links, flange }: ArmFrames): void {
    links.forEach((frame, index) => this.links[index]?.matrix.copy(matrixOf(frame)));
    this.flange.matrix.copy(matrixOf(flange));
  }

  /** Colours the parts that are too near to a thing, by their names in events. */
  mark(nearness: ReadonlyMap<string, Nearness>): void {
    this.materials.forEach((material, part) => markNearness(material, nearness.get(part === 0 ? "base" : `link${part}`)));
  }

  dispose(): void {
    this.isDisposed = true;
    this.group.removeFromParent();
    this.group.traverse((part) => {
      if (part instanceof Mesh) {
        (part.geometry as BufferGeometry).dispose();
      }
    });
  }

  /** Clips the base at the mounting face. Its capsule ends below this face, where no distance is computed. */
  private clipBase(arm: DrawnArm, base: readonly number[]): void {
    const [material] = this.materials;
    if (material !== undefined) {
      material.clippingPlanes = [new Plane(new Vector3(0, 0, 1), -floorHeight(arm) - frameOf(base).position[2])];
    }
  }

  /** Creates a part with the shape in its file, or as a solid without a file. */
  private part(name: string, shape: LinkShape | null | undefined, solid: () => Mesh): Group {
    const group = new Group();
    if (shape) {
      readShape(shape, this.look.body).then((read) => {
        group.add(read);
        this.changed();
      }, (fault: unknown) => {
        // A picture that was built again meanwhile reads its files itself.
        if (this.isDisposed) {
          return;
        }
        group.add(solid());
        this.changed(`${name} is drawn as a solid, because its file cannot be read: ${fault instanceof Error ? fault.message : String(fault)}`);
      });
    } else {
      group.add(solid());
    }
    return group;
  }

  private mesh(parts: BufferGeometry[], number: number): Mesh {
    const mesh = new Mesh(mergeGeometries(parts), this.materials[number]);
    parts.forEach((part) => part.dispose());
    mesh.castShadow = true;
    mesh.receiveShadow = true;
    return mesh;
  }
}
