// Applications in the workspace that can be debugged: projects with a program `start`.

import * as vscode from "vscode";
import { State } from "vscode-languageclient/node";
import type { Client } from "../client";

/** Program with which the controller starts an application. */
export const START = "start";

export interface Application {
  name: string;
  /** Project folder. */
  folder: vscode.Uri;
}

export async function applications(client: Client): Promise<Application[]> {
  const projects = client.state === State.Running ? await client.request("val3/workspaceTree") : [];
  const started = projects.filter(({ programs }) => programs.some(({ name }) => name === START));
  const found = started.map(({ name, uri }) => ({ name, folder: vscode.Uri.joinPath(vscode.Uri.parse(uri), "..") }));
  return found.sort((left, right) => left.name.localeCompare(right.name));
}

/** Returns the application of the active file, the only application, or one that the user selects. */
export async function pickApplication(client: Client): Promise<Application | undefined> {
  const found = await applications(client);
  const active = vscode.window.activeTextEditor?.document.uri.path;
  const own = found.filter(({ folder }) => active?.startsWith(`${folder.path}/`) === true);
  const only = own.length === 1 ? own : found;
  if (only.length === 1) {
    return only[0];
  } else if (found.length === 0) {
    void vscode.window.showErrorMessage("The workspace has no application to debug: a folder with a .pjx and a program start. "
      + "Open the folder of an application, or create one with the command \"VAL 3: New Application\".");
    return undefined;
  }
  const items = found.map((application) => ({
    label: application.name,
    description: vscode.workspace.asRelativePath(application.folder),
    application,
  }));
  return (await vscode.window.showQuickPick(items, { placeHolder: "The application to debug" }))?.application;
}
