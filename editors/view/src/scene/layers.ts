// Layers of the drawing, which the user can hide. The choice survives a reload.

import { signal } from "@preact/signals";
import { remember, remembered } from "../memory";

export const LAYERS = { points: "Points", frames: "Frames", objects: "Things around the arm", names: "Names", heights: "Heights above the floor", path: "Path", ahead: "Path ahead and blends" } as const;
export type Layer = keyof typeof LAYERS;

const KEY = "hiddenLayers";

export const hiddenLayers = signal(parsedLayers(remembered(KEY)));

export function showLayer(layer: Layer, isShown: boolean): void {
  const hidden = new Set(hiddenLayers.peek());
  if (isShown) {
    hidden.delete(layer);
  } else {
    hidden.add(layer);
  }
  hiddenLayers.value = hidden;
  remember(KEY, [...hidden].join());
}

/** Parses a list of layers. Other words are ignored. */
export function parsedLayers(text: string | undefined): ReadonlySet<Layer> {
  return new Set((text ?? "").split(",").filter((word): word is Layer => word in LAYERS));
}
