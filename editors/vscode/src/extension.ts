// The VS Code extension: starts `val3 lsp` and adds what the protocol does not know.

import * as vscode from "vscode";
import { State } from "vscode-languageclient/node";
import { Client } from "./client";
import { CodeFiles } from "./codeView/files";
import { registerCodeView } from "./codeView/commands";
import { registerCheckWorkspace } from "./commands/checkWorkspace";
import { registerNewApplication } from "./commands/newApplication";
import { registerNewProgram } from "./commands/newProgram";
import { registerPages } from "./commands/openPage";
import { CheckTasks } from "./tasks";
import { WorkspaceTree } from "./tree";

let client: Client | undefined;

export async function activate(context: vscode.ExtensionContext): Promise<void> {
  const views = new CodeFiles();
  client = new Client(context, views);
  const tree = new WorkspaceTree(client);
  context.subscriptions.push(
    views,
    client,
    tree,
    vscode.window.registerTreeDataProvider("val3.workspace", tree),
    vscode.tasks.registerTaskProvider("val3", new CheckTasks(client)),
    vscode.commands.registerCommand("val3.refreshTree", () => tree.refresh()),
    vscode.commands.registerCommand("val3.restartServer", () => client?.restart()),
    vscode.commands.registerCommand("val3.showOutput", () => client?.output.show()),
    client.onDidChangeState((state) => state === State.Running && tree.refresh()),
    vscode.workspace.onDidChangeConfiguration((change) => {
      if (change.affectsConfiguration("val3.server")) {
        void client?.restart();
      }
    }),
    ...registerCodeView(views),
    ...registerNewApplication(context),
    ...registerNewProgram(),
    ...registerCheckWorkspace(),
    ...registerPages(client),
  );
  await client.start();
}

export async function deactivate(): Promise<void> {
  await client?.stop();
}
