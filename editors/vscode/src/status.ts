// Server state in the language status of VAL 3 files.

import * as vscode from "vscode";
import { State } from "vscode-languageclient/node";
import type { Client } from "./client";
import type { Walkthrough } from "./walkthrough";

const LANGUAGES = ["val3", "val3-data", "val3-project", "val3-code"];

export function registerStatus(client: Client, walkthrough: Walkthrough): vscode.Disposable[] {
  const status = vscode.languages.createLanguageStatusItem("val3.server", LANGUAGES);
  status.name = "VAL 3";
  status.command = { command: "val3.restartServer", title: "Restart" };
  const show = (state: State): void => {
    const runs = state === State.Running;
    status.busy = state === State.Starting;
    status.text = runs ? `val3 ${client.version}` : state === State.Starting ? "val3 starts" : "val3 does not run";
    status.detail = client.command ?? "";
    status.severity = runs || status.busy ? vscode.LanguageStatusSeverity.Information : vscode.LanguageStatusSeverity.Error;
    // For the welcome text of the view "VAL 3".
    void vscode.commands.executeCommand("setContext", "val3.serverRuns", runs);
    if (runs && vscode.workspace.workspaceFolders !== undefined) {
      walkthrough.done("open");
    }
  };
  show(client.state);
  return [vscode.Disposable.from(status), client.onDidChangeState(show)];
}
