// Colours of things that are too near to each other, or touch.

import { Color, type MeshStandardMaterial } from "three";
import type { Nearness } from "../panels/clearance/encounters";

export const NEARNESS: Record<Nearness, number> = { near: 0xf08c00, contact: 0xd81e1e };

/** Colours a part, or shows its own colour again. */
export function markNearness(material: MeshStandardMaterial, nearness: Nearness | undefined): void {
  material.emissive = new Color(nearness === undefined ? 0 : NEARNESS[nearness]);
  material.emissiveIntensity = 0.75;
}
