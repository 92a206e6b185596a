// Choice of the layers that the drawing shows.

import type { JSX } from "preact";
import { hiddenLayers, type Layer, LAYERS, showLayer } from "./layers";
import { Menu } from "./Menu";

export function LayerChoice(): JSX.Element {
  const hidden = hiddenLayers.value;
  return (
    <Menu label="Layers" className="layers">
      {(Object.keys(LAYERS) as Layer[]).map((layer) => (
        <label key={layer}><input type="checkbox" checked={!hidden.has(layer)} onChange={({ currentTarget }) => showLayer(layer, currentTarget.checked)} /> {LAYERS[layer]}</label>
      ))}
    </Menu>
  );
}
