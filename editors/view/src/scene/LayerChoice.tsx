// Choice of the layers that the drawing shows.

import type { JSX } from "preact";
import { hiddenLayers, type Layer, LAYERS, showLayer } from "./layers";

export function LayerChoice(): JSX.Element {
  const hidden = hiddenLayers.value;
  return (
    <details class="layers">
      <summary>Layers</summary>
      <div role="group" aria-label="Layers">
        {(Object.keys(LAYERS) as Layer[]).map((layer) => (
          <label key={layer}><input type="checkbox" checked={!hidden.has(layer)} onChange={({ currentTarget }) => showLayer(layer, currentTarget.checked)} /> {LAYERS[layer]}</label>
        ))}
      </div>
    </details>
  );
}
