// *Run | Debug* above programs: the commands of the server's code lenses.

import * as vscode from "vscode";
import { checkTrust } from "../trust";
import type { Application } from "./applications";
import { ofApplication } from "./configurations";

export const RUN = "val3.run";
export const DEBUG = "val3.debug";

export function registerLenses(): vscode.Disposable[] {
  return [
    vscode.commands.registerCommand(RUN, (project: string, program?: string) => start(project, program, true)),
    vscode.commands.registerCommand(DEBUG, (project: string, program?: string) => start(project, program, false)),
  ];
}

/** Starts a program of the project with this .pjx. */
async function start(project: string, program: string | undefined, noDebug: boolean): Promise<void> {
  const uri = vscode.Uri.parse(project);
  const folder = vscode.Uri.joinPath(uri, "..");
  const name = uri.path.slice(uri.path.lastIndexOf("/") + 1).replace(/\.pjx$/i, "");
  await startApplication({ name, folder }, program, noDebug);
}

/** Starts a program of an application, with or without the debugger. */
export async function startApplication(application: Application, program: string | undefined, noDebug: boolean): Promise<void> {
  if (!checkTrust("Running a program")) {
    return;
  }
  const { folder } = application;
  const configuration = ofApplication(application, program);
  await vscode.debug.startDebugging(vscode.workspace.getWorkspaceFolder(folder), configuration, { noDebug });
}
