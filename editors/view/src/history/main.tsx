// Entry of the page for a variable: its history, or array elements.

import { render } from "preact";
import "./history.css";
import type { FromPage, ToPage } from "./messages";
import { HistoryModel } from "./model";
import { TableModel } from "./table";
import { followTheme } from "./theme";
import { VariablePage } from "./VariablePage";

interface Editor {
  postMessage: (message: FromPage) => void;
}

const editor = (window as { acquireVsCodeApi?: () => Editor }).acquireVsCodeApi?.();
const post = (message: FromPage): void => editor?.postMessage(message);
const [history, table] = [new HistoryModel(post), new TableModel(post)];
followTheme();
render(<VariablePage history={history} table={table} />, document.body);
window.addEventListener("message", ({ data }: MessageEvent<ToPage>) => {
  history.take(data);
  table.take(data);
});
post({ command: "ready" });
