// Page with the history of a variable: list and plot.

import type { JSX } from "preact";
import type { History } from "./messages";
import type { HistoryModel } from "./model";
import { PlotSection } from "./PlotSection";
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
        {history.series.length === 0 ? <p class="empty">{withoutPlot(history)}</p> : <PlotSection model={model} shownPart="time" earlier="Earlier" later="Later" />}
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
