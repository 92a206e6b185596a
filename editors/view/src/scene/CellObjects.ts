// Things around the arm, and parts. Each is drawn relative to the frame, tool or link that carries it.

import { Box3, Group, Mesh, MeshStandardMaterial } from "three";
import type { ArmFrames } from "../kinematics";
import type { Nearness } from "../panels/clearance/encounters";
import { composed, type Frame, frameOf, IDENTITY } from "../panels/pendant/pose";
import { pointText } from "../panels/points/edits";
import type { CellPoint } from "../panels/shared/cell";
import type { CellObject, CellPart, ObjectCarrier, PartPlace } from "../wire";
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

/** Drawn thing or part. A part has no fixed carrier, because programs grip and release it. */
interface Drawn {
  carrier: ObjectCarrier | undefined;
  name: string;
  body: Group;
  meshes: Mesh[];
  material: MeshStandardMaterial;
}

export class CellObjects {
  readonly group = new Group();
  private readonly drawn: Drawn[];

  constructor(objects: readonly CellObject[], parts: readonly CellPart[], look: Look) {
    const draw = ({ name, colour, shapes }: CellPart, carrier?: ObjectCarrier): Drawn => {
      const material = new MeshStandardMaterial({ color: colour ?? look.object, roughness: 0.7, metalness: 0.05 });
      const body = new Group();
      body.matrixAutoUpdate = false;
      const meshes = shapes.map((shape) => new Mesh(objectSolid(shape), material));
      for (const mesh of meshes) {
        mesh.castShadow = true;
        mesh.receiveShadow = true;
        body.add(mesh);
      }
      return { carrier, name, body, meshes, material };
    };
    this.drawn = [...objects.map((object) => draw(object, object.carrier)), ...parts.map((part) => draw(part))];
    this.drawn.forEach(({ body }) => this.group.add(body));
  }

  /** Places the things and the parts. A thing or part whose frame is unknown is hidden. */
  place(frames: CarrierFrames, places: readonly PartPlace[], nearness: ReadonlyMap<string, Nearness>): void {
    const parts = new Map(places.map((place) => [place.name, place]));
    for (const { carrier, name, body, material } of this.drawn) {
      const frame = carrier === undefined ? partFrame(parts.get(name), frames) : carrierFrame(carrier, frames);
      body.visible = frame !== undefined;
      if (frame !== undefined) {
        body.matrix.copy(matrixOf(frame));
      }
      markNearness(material, nearness.get(name));
    }
  }

  /** Returns the height of the lowest point of all visible things in world or in a frame; `Infinity` if there are none. */
  lowest(): number {
    this.group.updateMatrixWorld(true);
    const standing = this.drawn.filter(({ carrier, body }) => body.visible && (carrier?.kind === "world" || carrier?.kind === "frame"));
    return Math.min(...standing.map(({ body }) => new Box3().setFromObject(body).min.z));
  }

  dispose(): void {
    this.group.removeFromParent();
    for (const { meshes, material } of this.drawn) {
      meshes.forEach((mesh) => mesh.geometry.dispose());
      material.dispose();
    }
  }
}

/** Returns the frame of a part in world; `undefined` if the part was removed or its carrier's frame is unknown. */
export function partFrame(place: PartPlace | undefined, frames: CarrierFrames): Frame | undefined {
  if (place === undefined || place.carrier === null) {
    return undefined;
  }
  const frame = carrierFrame(place.carrier, frames);
  return frame && composed(frame, frameOf(place.pose));
}

/** Returns the frame of a carrier in world; `undefined` if there is no such frame, tool or link. */
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
