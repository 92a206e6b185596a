// Things around the arm, at the places of their carriers.

import { Box3, Group, Mesh, MeshStandardMaterial } from "three";
import type { ArmFrames } from "../kinematics";
import type { Nearness } from "../panels/clearance/encounters";
import { composed, type Frame, frameOf, IDENTITY } from "../panels/pendant/pose";
import { pointText } from "../panels/points/edits";
import type { CellPoint } from "../panels/shared/cell";
import type { CellObject, ObjectCarrier } from "../wire";
import type { Look } from "./palette";
import { markNearness } from "./nearness";
import { objectSolid } from "./solids";
import { matrixOf } from "./three";

/** Frames to which carriers refer. */
export interface CarrierFrames {
  base: Frame;
  arm: ArmFrames;
  frames: readonly CellPoint[];
  tools: readonly CellPoint[];
}

export class CellObjects {
  readonly group = new Group();
  private readonly parts: { carrier: ObjectCarrier; name: string; part: Group; meshes: Mesh[]; material: MeshStandardMaterial }[];

  constructor(objects: readonly CellObject[], look: Look) {
    this.parts = objects.map(({ name, carrier, colour, shapes }) => {
      const material = new MeshStandardMaterial({ color: colour ?? look.object, roughness: 0.7, metalness: 0.05 });
      const part = new Group();
      part.matrixAutoUpdate = false;
      const meshes = shapes.map((shape) => new Mesh(objectSolid(shape), material));
      for (const mesh of meshes) {
        mesh.castShadow = true;
        mesh.receiveShadow = true;
        part.add(mesh);
      }
      return { carrier, name, part, meshes, material };
    });
    this.parts.forEach(({ part }) => this.group.add(part));
  }

  /** Places the things. A thing whose carrier has no place is hidden. */
  place(frames: CarrierFrames, nearness: ReadonlyMap<string, Nearness>): void {
    for (const { carrier, name, part, material } of this.parts) {
      const frame = carrierFrame(carrier, frames);
      part.visible = frame !== undefined;
      if (frame !== undefined) {
        part.matrix.copy(matrixOf(frame));
      }
      markNearness(material, nearness.get(name));
    }
  }

  /** Returns the height of the lowest point of standing things; `Infinity` without one. */
  lowest(): number {
    this.group.updateMatrixWorld(true);
    const standing = this.parts.filter(({ carrier, part }) => part.visible && (carrier.kind === "world" || carrier.kind === "frame"));
    return Math.min(...standing.map(({ part }) => new Box3().setFromObject(part).min.z));
  }

  dispose(): void {
    this.group.removeFromParent();
    for (const { meshes, material } of this.parts) {
      meshes.forEach((mesh) => mesh.geometry.dispose());
      material.dispose();
    }
  }
}

/** Returns the frame of a carrier in world; `undefined` without such a frame, tool or link. */
export function carrierFrame(carrier: ObjectCarrier, { base, arm, frames, tools }: CarrierFrames): Frame | undefined {
  switch (carrier.kind) {
    case "world": return IDENTITY;
    case "flange": return arm.flange;
    case "link": return carrier.link === 0 ? base : arm.links[carrier.link - 1];
    case "frame": return poseNamed(frames, carrier.name);
    case "tool": {
      const tool = poseNamed(tools, carrier.name);
      return tool && composed(arm.flange, tool);
    }
  }
}

function poseNamed(points: readonly CellPoint[], name: string): Frame | undefined {
  const names = (point: CellPoint): string[] => [pointText(point), `${point.name}[${point.key ?? ""}]`, ...(point.key === "0" ? [point.name] : [])];
  const found = points.find((point) => names(point).includes(name));
  return found && frameOf(found.pose);
}
