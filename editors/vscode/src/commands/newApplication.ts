// "New Application": asks for a name and copies the template.

import * as vscode from "vscode";
import type { Walkthrough } from "../walkthrough";
import { nameFault } from "./names";

const PLACEHOLDER = /application/g;

export function registerNewApplication(context: vscode.ExtensionContext, walkthrough: Walkthrough): vscode.Disposable[] {
  const template = vscode.Uri.joinPath(context.extensionUri, "templates", "application");
  return [vscode.commands.registerCommand("val3.newApplication", () => newApplication(template, walkthrough))];
}

async function newApplication(template: vscode.Uri, walkthrough: Walkthrough): Promise<void> {
  const parent = await chooseFolder();
  if (parent === undefined) {
    return;
  }
  const taken = new Set((await vscode.workspace.fs.readDirectory(parent)).map(([name]) => name.toLowerCase()));
  const name = await vscode.window.showInputBox({
    prompt: `The name of the application, which becomes a folder in ${vscode.workspace.asRelativePath(parent)}`,
    ignoreFocusOut: true,
    validateInput: (name) => nameFault(name, (lower) => taken.has(lower)),
  });
  if (name === undefined) {
    return;
  }
  const folder = vscode.Uri.joinPath(parent, name);
  await copyTemplate(template, folder, name);
  walkthrough.done("new");
  await vscode.commands.executeCommand("vscode.open", vscode.Uri.joinPath(folder, "start.pgx"));
}

/** The `usrapp` of a cell, the workspace folder, or a folder that the user picks. */
async function chooseFolder(): Promise<vscode.Uri | undefined> {
  const projects = await vscode.workspace.findFiles("**/usrapp/**/*.pjx", undefined, 1000);
  const roots = projects.map((uri) => uri.with({ path: uri.path.replace(/(\/usrapp)\/.*$/, "$1") }));
  const folders = [...roots, ...(vscode.workspace.workspaceFolders ?? []).map(({ uri }) => uri)];
  const unique = [...new Map(folders.map((uri) => [uri.toString(), uri])).values()];
  if (unique.length === 0) {
    return (await vscode.window.showOpenDialog({ canSelectFolders: true, canSelectFiles: false }))?.[0];
  }
  const items = unique.map((uri) => ({ label: vscode.workspace.asRelativePath(uri), description: uri.fsPath, uri }));
  const picked = items.length === 1 ? items[0] : await vscode.window.showQuickPick(items, { placeHolder: "The folder of the new application", ignoreFocusOut: true });
  return picked?.uri;
}

async function copyTemplate(template: vscode.Uri, folder: vscode.Uri, name: string): Promise<void> {
  for (const [file] of await vscode.workspace.fs.readDirectory(template)) {
    const text = Buffer.from(await vscode.workspace.fs.readFile(vscode.Uri.joinPath(template, file))).toString();
    const target = vscode.Uri.joinPath(folder, file.replace(PLACEHOLDER, name));
    await vscode.workspace.fs.writeFile(target, Buffer.from(text.replace(PLACEHOLDER, name)));
  }
}
