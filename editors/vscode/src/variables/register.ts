// Table of parameters and locals below the workspace tree.

import * as vscode from "vscode";
import type { Client } from "../client";
import type { CodeFiles } from "../codeView/files";
import { VariablesView } from "./view";

/** `report` receives the errors of background work. */
export function registerVariables(
  context: vscode.ExtensionContext,
  client: Client,
  views: CodeFiles,
  report: (fault: unknown) => void,
): vscode.Disposable[] {
  const view = new VariablesView(client, views, vscode.Uri.joinPath(context.extensionUri, "dist/variables.html"), report);
  return [vscode.Disposable.from(view), vscode.window.registerWebviewViewProvider("val3.variables", view)];
}
