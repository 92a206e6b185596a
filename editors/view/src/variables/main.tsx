// Entry of the view "Variables": the parameters and locals of the program in the editor.

import { render } from "preact";
import type { FromPage, ToPage } from "./messages";
import { VariablesModel } from "./model";
import "./variables.css";
import { VariablesPage } from "./VariablesPage";

interface Editor {
  postMessage: (message: FromPage) => void;
}

const editor = (window as { acquireVsCodeApi?: () => Editor }).acquireVsCodeApi?.();
const model = new VariablesModel((message) => editor?.postMessage(message));
render(<VariablesPage model={model} />, document.body);
window.addEventListener("message", ({ data }: MessageEvent<ToPage>) => model.take(data));
editor?.postMessage({ command: "ready" });
