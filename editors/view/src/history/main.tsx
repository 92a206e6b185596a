// Entry of the page with the history of a variable.

import { render } from "preact";
import "./history.css";
import { HistoryPage } from "./HistoryPage";
import type { FromPage, ToPage } from "./messages";
import { HistoryModel } from "./model";
import { followTheme } from "./theme";

interface Editor {
  postMessage: (message: FromPage) => void;
}

const editor = (window as { acquireVsCodeApi?: () => Editor }).acquireVsCodeApi?.();
const model = new HistoryModel((message) => editor?.postMessage(message));
followTheme();
render(<HistoryPage model={model} />, document.body);
window.addEventListener("message", ({ data }: MessageEvent<ToPage>) => model.take(data));
editor?.postMessage({ command: "ready" });
