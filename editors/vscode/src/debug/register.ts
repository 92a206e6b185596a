// Registers the debugger in VS Code.

import * as vscode from "vscode";
import type { Client } from "../client";
import type { CodeFiles } from "../codeView/files";
import type { Walkthrough } from "../walkthrough";
import { Adapter } from "./adapter";
import { Configurations, TYPE } from "./configurations";
import { registerLenses } from "./lenses";
import { OtherBreakpoints } from "./otherBreakpoints";
import { registerMotion } from "./robot/motion";
import { registerSignals } from "./robot/signals";
import { RobotTree } from "./robot/tree";
import { UserPageView } from "./robot/userPage";
import { DebuggedRun } from "./run";
import { SourceTranslator } from "./sources";
import { registerTaskCommands } from "./taskCommands";
import { registerVariableFilter } from "./variables";
import { registerVariableTabs } from "./variableTabs";
import { RobotView } from "./view/panel";
import { Preview } from "./view/preview";
import { DebugViews } from "./views";

/** `report` receives the errors of background work; `selected` fires when a row of the data tables is selected. */
export function registerDebugging(
  context: vscode.ExtensionContext,
  client: Client,
  files: CodeFiles,
  walkthrough: Walkthrough,
  report: (fault: unknown) => void,
  selected: vscode.Event<string | undefined>,
): vscode.Disposable[] {
  const views = new DebugViews(files);
  const run = new DebuggedRun(report);
  const robot = new RobotTree(run, report);
  const icons = vscode.Uri.joinPath(context.extensionUri, "icons");
  const page = new UserPageView(run, vscode.Uri.joinPath(context.extensionUri, "media"));
  const view = new RobotView(run, new Preview(client), vscode.Uri.joinPath(context.extensionUri, "dist/view.html"), context.workspaceState, report);
  return [
    vscode.commands.registerCommand("val3.showRobot", (project?: unknown) => {
      walkthrough.done("robot");
      return view.show(typeof project === "string" ? vscode.Uri.parse(project) : undefined);
    }),
    selected((name) => view.select(name)),
    vscode.Disposable.from(run, robot, page, view, new OtherBreakpoints(views, icons)),
    ...registerAdapter(client, views),
    vscode.window.registerTreeDataProvider("val3.robot", robot),
    vscode.window.registerWebviewViewProvider("val3.userPage", page),
    ...registerSignals(run),
    ...registerMotion(run, views, icons, report),
    ...registerTaskCommands(run),
    registerVariableFilter(run),
    ...registerVariableTabs(run, vscode.Uri.joinPath(context.extensionUri, "dist/history.html"), report),
    ...registerLenses(),
    vscode.debug.onDidStartDebugSession(({ type }) => type === TYPE && walkthrough.done("debug")),
  ];
}

function registerAdapter(client: Client, views: DebugViews): vscode.Disposable[] {
  const configurations = new Configurations(client);
  const { Initial, Dynamic } = vscode.DebugConfigurationProviderTriggerKind;
  return [
    vscode.debug.registerDebugConfigurationProvider(TYPE, configurations, Initial),
    vscode.debug.registerDebugConfigurationProvider(TYPE, configurations, Dynamic),
    vscode.debug.registerDebugAdapterDescriptorFactory(TYPE, {
      createDebugAdapterDescriptor: ({ workspaceFolder }) => {
        if (!vscode.workspace.isTrusted) {
          throw new Error("Debugging executes code of this folder, which you do not trust.");
        } else if (client.command === undefined) {
          throw new Error("The command val3 was not found. Install it, or name it in the setting val3.server.path.");
        }
        const adapter = new Adapter(client.command, workspaceFolder?.uri.fsPath, new SourceTranslator(views));
        return new vscode.DebugAdapterInlineImplementation(adapter);
      },
    }),
  ];
}
