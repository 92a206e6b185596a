// The pendant: the user page, 40 x 14 characters, and the keyboard.

import * as vscode from "vscode";
import type { DebuggedRun, UserPage } from "../run";
import { keyArgument } from "./input";

/** Message from the page: a key, by its name or as its character. */
interface Press {
  key: string;
}

export class UserPageView implements vscode.WebviewViewProvider, vscode.Disposable {
  private readonly subscription: vscode.Disposable;
  private view: vscode.WebviewView | undefined;
  private page: UserPage | undefined;

  constructor(private readonly run: DebuggedRun, private readonly folder: vscode.Uri) {
    this.subscription = run.onDidChangePage((page) => {
      this.page = page;
      this.show();
    });
  }

  dispose(): void {
    this.subscription.dispose();
  }

  resolveWebviewView(view: vscode.WebviewView): void {
    this.view = view;
    const { webview } = view;
    webview.options = { enableScripts: true, localResourceRoots: [this.folder] };
    webview.onDidReceiveMessage((message: Press | "ready") => {
      if (message === "ready") {
        this.show();
      } else {
        void this.run.change("val3/key", keyArgument(message.key));
      }
    });
    view.onDidDispose(() => (this.view = undefined));
    webview.html = html(webview, this.folder);
  }

  private show(): void {
    void this.view?.webview.postMessage(this.page ?? { screen: "", title: "", lines: [] });
  }
}

function html(webview: vscode.Webview, folder: vscode.Uri): string {
  const file = (name: string): string => webview.asWebviewUri(vscode.Uri.joinPath(folder, name)).toString();
  return `<!DOCTYPE html>
<html lang="en">
<head>
  <meta charset="utf-8">
  <meta http-equiv="Content-Security-Policy" content="default-src 'none'; style-src ${webview.cspSource}; script-src ${webview.cspSource}">
  <link rel="stylesheet" href="${file("pendant.css")}">
  <title>User page</title>
</head>
<body>
  <div id="pendant" tabindex="0" role="application" aria-label="Pendant. Keys that are typed here go to the application.">
    <div>
      <div id="title"></div>
      <pre id="page" aria-live="polite"></pre>
      <div id="menu"></div>
    </div>
    <div id="keys"></div>
  </div>
  <script src="${file("pendant.js")}"></script>
</body>
</html>`;
}
