// *Run | Debug* above programs: the commands of the server's code lenses.

import * as vscode from "vscode";
import { checkTrust } from "../trust";
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
  if (!checkTrust("Running a program")) {
    return;
  }
  const uri = vscode.Uri.parse(project);
  const folder = vscode.Uri.joinPath(uri, "..");
  const name = uri.path.slice(uri.path.lastIndexOf("/") + 1).replace(/\.pjx$/i, "");
  const configuration = ofApplication({ name, folder }, program);
  await vscode.debug.startDebugging(vscode.workspace.getWorkspaceFolder(folder), configuration, { noDebug });
}
