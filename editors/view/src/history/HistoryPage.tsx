// Page with the history of a variable: list and plot.

import type { JSX } from "preact";
import { DASHES, STYLES } from "./drawPlot";
import { unitSign } from "./lanes";
import type { History } from "./messages";
import type { HistoryModel } from "./model";
import { PlotView } from "./PlotView";
import { timeText } from "./steps";
import { WriteList } from "./WriteList";

export function HistoryPage({ model }: { model: HistoryModel }): JSX.Element {
  const history = model.history.value;
  const note = model.note.value;
  if (history === undefined) {
    return <main class="history"><p class="empty" role="status">{note ?? "The history is being searched."}</p></main>;
  }
  return (
    <main class="history">
      <header>
        <h1>{history.name}</h1>
        <span class="muted">{history.type}</span>
        <span class="muted">{countText(history)}</span>
        <span class="present">present: {timeText(history.now)}</span>
      </header>
      {note === null ? null : <p class="note" role="status">{note}</p>}
      <div class={history.series.length === 0 ? "parts list-only" : "parts"}>
        <WriteList model={model} />
        {history.series.length === 0 ? <p class="empty">{withoutPlot(history)}</p> : (
          <section aria-label="Plot">
            <Tools model={model} series={history.series} />
            {model.shown.value.size === 0 ? <p class="empty">Choose a number above to plot it.</p> : <PlotView model={model} />}
          </section>
        )}
      </div>
    </main>
  );
}

function countText({ writes, more, initial }: History): string {
  const count = writes.length === 1 ? "1 write" : `${writes.length} writes`;
  if (writes.length === 0 && initial !== null) {
    return "no write is recorded";
  }
  return more ? `the last ${count}` : count;
}

/** States why there is no plot. */
function withoutPlot({ type }: History): string {
  return type === ""
    ? "The value was not in memory, so there is nothing to plot."
    : `Values of the type ${type} are listed without a plot. Numbers, bool, dio, aio, joints and positions are plotted, also as elements and fields.`;
}

function Tools({ model, series }: { model: HistoryModel; series: History["series"] }): JSX.Element {
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
      <div role="group" aria-label="Shown time">
        <button type="button" aria-label="Earlier" onClick={() => model.shift(-0.5)}>◀</button>
        <button type="button" aria-label="Later" onClick={() => model.shift(0.5)}>▶</button>
        <button type="button" aria-label="Zoom in" onClick={() => model.zoom(0.5, selectedTime(model) ?? middle)}>+</button>
        <button type="button" aria-label="Zoom out" onClick={() => model.zoom(2, middle)}>−</button>
        <button type="button" onClick={() => model.showAll()}>All</button>
      </div>
    </div>
  );
}

/** Returns the time of the selected step if it is shown. */
function selectedTime(model: HistoryModel): number | undefined {
  const t = model.steps.peek()[model.selected.peek()]?.t;
  const [start, end] = model.range.peek();
  return t !== undefined && t >= start && t <= end ? t : undefined;
}
