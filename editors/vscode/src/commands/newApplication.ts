// "New Application": prompts for name, version and arm, and calls `val3 new`, which contains the template.

import * as vscode from "vscode";
import type { Client } from "../client";
import { follow } from "../testing/process";
import type { Walkthrough } from "../walkthrough";
import { nameFault } from "./names";

/** Choice with which `val3 new` determines the value. */
const DEFAULT = "From the cell";

const VERSIONS = [
  { label: "s8.20", description: "CS9 controllers" },
  { label: "s7.11.3", description: "CS8 controllers" },
];

export function registerNewApplication(client: Client, walkthrough: Walkthrough): vscode.Disposable[] {
  return [vscode.commands.registerCommand("val3.newApplication", () => newApplication(client, walkthrough))];
}

async function newApplication(client: Client, walkthrough: Walkthrough): Promise<void> {
  const { command } = client;
  if (command === undefined) {
    void vscode.window.showErrorMessage("A new application needs the server val3, which was not found.");
    return;
  }
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
  const version = name && (await choose("The version of VAL 3 on the controller", VERSIONS, "or the newest one for the arm"));
  const arm = version && (await choose("The arm", await arms(command, parent.fsPath), "or a TX2-90"));
  if (name === undefined || version === undefined || arm === undefined) {
    return;
  }
  const options = [["--version", version], ["--arm", arm]].filter(([, value]) => value !== DEFAULT).flat();
  const words = ["new", name, "--folder", parent.fsPath, "--format", "json", ...options];
  const { lines, errors, code } = await output(command, words, parent.fsPath);
  if (code !== 0) {
    void vscode.window.showErrorMessage(errors.trim().replace(/^error: /, ""));
    return;
  }
  const { application } = JSON.parse(lines.join("\n")) as { application: string };
  walkthrough.done("new");
  await vscode.commands.executeCommand("vscode.open", vscode.Uri.joinPath(vscode.Uri.file(application), "start.pgx"));
}

/** Returns the label of the item that the user selects, which may be `DEFAULT`. */
async function choose(question: string, items: readonly vscode.QuickPickItem[], otherwise: string): Promise<string | undefined> {
  const all = [{ label: DEFAULT, description: otherwise }, ...items];
  return (await vscode.window.showQuickPick(all, { placeHolder: question, ignoreFocusOut: true }))?.label;
}

/** Returns the shipped arms: the first column of `val3 arm list`, below the head. */
async function arms(command: string, folder: string): Promise<vscode.QuickPickItem[]> {
  const { lines } = await output(command, ["arm", "list"], folder);
  return lines.slice(1).filter((line) => line !== "").map((line) => {
    const [label = "", ...description] = line.split(/\s{2,}|\s(?=[\d ]+ mm)/);
    return { label, description: description.slice(0, 2).join(", ") };
  });
}

/** Runs a command, and returns its output lines, its error output and its exit code. */
async function output(command: string, words: string[], folder: string): Promise<{ lines: string[]; errors: string; code: number | null }> {
  const lines: string[] = [];
  const ended = await follow(command, words, { folder, line: (line) => lines.push(line) });
  return { lines, ...ended };
}

/** Returns the `usrapp` of a cell, the workspace folder, or a folder that the user selects. */
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
