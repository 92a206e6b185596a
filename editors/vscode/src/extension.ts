// The VS Code extension: starts `val3 lsp`, and adds features outside the protocol.

import * as vscode from "vscode";
import { Client } from "./client";
import { CodeFiles } from "./codeView/files";
import { registerCodeView } from "./codeView/commands";
import { registerCheckWorkspace } from "./commands/checkWorkspace";
import { registerNewApplication } from "./commands/newApplication";
import { registerNewProgram } from "./commands/newProgram";
import { registerPages } from "./commands/openPage";
import { registerRename } from "./commands/rename";
import { registerShowReferences } from "./commands/showReferences";
import { registerController } from "./controller/register";
import { registerDataEditor } from "./dataEditor/provider";
import { registerDebugging } from "./debug/register";
import { registerEncodings } from "./encoding/documents";
import { Findings } from "./findings";
import { registerTools } from "./languageModels";
import { registerStatus } from "./status";
import { CheckTasks } from "./tasks";
import { registerTesting } from "./testing/register";
import { registerTree } from "./tree/register";
import { whenTrusted } from "./trust";
import { registerVariables } from "./variables/register";
import { Walkthrough } from "./walkthrough";

let client: Client | undefined;

export async function activate(context: vscode.ExtensionContext): Promise<void> {
  const output = vscode.window.createOutputChannel("VAL 3", { log: true });
  const report = (fault: unknown): void => output.error(String(fault));
  const views = new CodeFiles(report);
  const findings = new Findings(views);
  const started = new Client(context, output, views, findings);
  const walkthrough = new Walkthrough(context.globalState, report);
  // The view of the robot highlights the datum that is selected in the tables.
  const selection = new vscode.EventEmitter<string | undefined>();
  client = started;
  context.subscriptions.push(
    output,
    views,
    findings,
    started,
    walkthrough,
    selection,
    vscode.tasks.registerTaskProvider("val3", new CheckTasks(started)),
    vscode.commands.registerCommand("val3.restartServer", () => started.restart()),
    vscode.commands.registerCommand("val3.showOutput", () => output.show()),
    vscode.workspace.onDidChangeConfiguration((change) => {
      if (change.affectsConfiguration("val3.server")) {
        void started.restart();
      }
    }),
    // In a trusted folder, the server announces commands that execute programs, and the server itself may differ.
    vscode.workspace.onDidGrantWorkspaceTrust(() => void started.restart()),
    ...registerEncodings(report),
    ...registerStatus(started, walkthrough),
    ...registerCodeView(views, walkthrough),
    ...registerDataEditor(context, started, report, (name) => selection.fire(name)),
    ...registerNewApplication(started, walkthrough),
    ...registerNewProgram(),
    ...registerTree(started, context.workspaceState, output),
    ...registerCheckWorkspace(walkthrough),
    ...registerPages(started),
    ...registerShowReferences(),
    ...registerRename(views),
    ...registerVariables(context, started, views, report),
    whenTrusted(() => registerController(started, report)),
    whenTrusted(() => registerTesting(started, output)),
    whenTrusted(() => registerTools(started)),
    ...registerDebugging(context, started, views, walkthrough, report, selection.event),
  );
  await started.restart();
}

export async function deactivate(): Promise<void> {
  await client?.stop();
}
