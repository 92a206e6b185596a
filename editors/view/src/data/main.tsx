// Page that shows a data file as tables.

import { effect } from "@preact/signals";
import { type JSX, render } from "preact";
import { followLook } from "../look";
import { NoticeLine } from "../panels/shared/NoticeLine";
import { withChanges } from "./changes";
import { Dialogs } from "./Dialogs";
import { Grid } from "./Grid";
import { type EditorMessage, Host } from "./host";
import { ALL, DataModel } from "./model";
import { StatusLine } from "./StatusLine";
import { SEARCH, ToolBar } from "./ToolBar";
import { TypeTabs } from "./TypeTabs";
import "./data.css";

function Page({ model }: { model: DataModel }): JSX.Element {
  const unavailable = model.unavailable.value;
  if (model.tables.value === undefined) {
    return <main class="data"><h1 class="hidden">Data</h1><p class="empty" role="status">{unavailable === "" ? "The tables are being loaded." : unavailable}</p></main>;
  }
  return (
    <main class="data">
      <h1 class="hidden">Data</h1>
      <ToolBar model={model} />
      {unavailable === "" ? null : <p class="problem" role="alert">{unavailable}</p>}
      {model.blocked.value === undefined ? null : <p class="problem" role="alert">{model.blocked.value} <button type="button" class="place" onClick={() => model.host?.notify("openText")}>Open the text</button></p>}
      <NoticeLine notice={model.notice} />
      <TypeTabs model={model} />
      <section id="table" role="tabpanel" aria-labelledby={`type-${model.shown.value}`}>
        <Grid key={model.shown.value} model={model} label={model.shown.value === ALL ? "All data" : `Data of the type ${model.shown.value}`} empty={emptyText(model)} />
      </section>
      <StatusLine model={model} />
      <Dialogs model={model} />
    </main>
  );
}

function emptyText(model: DataModel): string {
  const { all } = model.counts.value.get(model.shown.value) ?? { all: 0 };
  const elsewhere = model.counts.value.get(ALL)?.found ?? 0;
  const what = model.shown.value === ALL ? "The file has no data" : `The file has no data of the type ${model.shown.value}`;
  return all === 0 ? `${what}. Add… declares some.` : elsewhere > 0 ? "No data of this type match. The list of types shows where the matches are." : "No data match the search and the filters.";
}

function take(model: DataModel, message: EditorMessage): void {
  switch (message.kind) {
    case "tables":
      model.take(message.tables);
      break;
    case "changes": {
      const tables = model.tables.peek();
      if (tables !== undefined) {
        model.take(withChanges(tables, message.changes));
      }
      break;
    }
    case "unavailable":
      model.unavailable.value = message.reason;
      break;
    case "reveal":
      model.reveal(message.name, message.key);
      document.querySelector<HTMLElement>("[role=treegrid]")?.focus({ preventScroll: true });
      break;
  }
}

/** Moves the focus to the search with Ctrl+F from any element. */
function searchKeys(event: KeyboardEvent): void {
  if ((event.ctrlKey || event.metaKey) && !event.shiftKey && !event.altKey && event.key.toLowerCase() === "f") {
    event.preventDefault();
    event.stopPropagation();
    const search = document.getElementById(SEARCH);
    if (search instanceof HTMLInputElement) {
      search.focus();
      search.select();
    }
  }
}

const model = new DataModel();
followLook();
render(<Page model={model} />, document.body);
document.addEventListener("keydown", searchKeys);
model.host = Host.connect((message) => take(model, message));
effect(() => {
  // For the editor's button that opens the text.
  model.host?.notify("selected", { name: model.activeRow()?.container.name });
});
