// Plot with the buttons for its series and its shown part.

import type { JSX } from "preact";
import { DASHES, STYLES } from "./drawPlot";
import { unitSign } from "./lanes";
import type { PlotModel } from "./plotModel";
import { PlotView } from "./PlotView";

interface PlotProperties {
  model: PlotModel;
  /** Word for the horizontal axis. */
  shownPart: string;
  /** Labels of the buttons that move the shown part. */
  earlier: string;
  later: string;
}

export function PlotSection(properties: PlotProperties): JSX.Element {
  const { model } = properties;
  return (
    <section aria-label="Plot">
      <Tools {...properties} />
      {model.shown.value.size === 0 ? <p class="empty">Choose a number above to plot it.</p> : <PlotView model={model} />}
    </section>
  );
}

function Tools({ model, shownPart, earlier, later }: PlotProperties): JSX.Element {
  const series = model.series.value;
  const [start, end] = model.range.value;
  const middle = (start + end) / 2;
  return (
    <div class="tools">
      {series.length === 1 ? <span class="muted">{unitSign(series[0]?.unit ?? null)}</span> : (
        <div role="group" aria-label="Plotted numbers">
          {series.map(({ name, unit }, index) => (
            <button type="button" key={name} aria-pressed={model.shown.value.has(index)} title={`${name}${unit === null ? "" : ` in ${unit}`}`} onClick={() => model.toggle(index)}>
              <svg class={`line-${index % STYLES + 1}`} width="22" height="8" aria-hidden="true"><line x1="0" y1="4" x2="22" y2="4" stroke-dasharray={DASHES[index % STYLES]?.join(" ")} /></svg>
              {name}
            </button>
          ))}
        </div>
      )}
      <div role="group" aria-label={`Shown ${shownPart}`}>
        <button type="button" aria-label={earlier} onClick={() => model.shift(-0.5)}>◀</button>
        <button type="button" aria-label={later} onClick={() => model.shift(0.5)}>▶</button>
        <button type="button" aria-label="Zoom in" onClick={() => model.zoom(0.5, selectedPosition(model) ?? middle)}>+</button>
        <button type="button" aria-label="Zoom out" onClick={() => model.zoom(2, middle)}>−</button>
        <button type="button" onClick={() => model.showAll()}>All</button>
      </div>
    </div>
  );
}

/** Returns the position of the selected step if it is shown. */
function selectedPosition(model: PlotModel): number | undefined {
  const t = model.steps.peek()[model.selected.peek()]?.t;
  const [start, end] = model.range.peek();
  return t !== undefined && t >= start && t <= end ? t : undefined;
}
