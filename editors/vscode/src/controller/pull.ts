// "Pull": copies the files of the controller, and keeps local changes.

import * as vscode from "vscode";
import { reason } from "../tree/changes";
import { addressFault, EXAMPLE } from "./address";
import { summaryOf } from "./messages";
import { localFolders, type Project, readProject } from "./projects";
import type { Finished, Transfers } from "./transfers";

/** Exit code of `val3 pull` for files that both sides have changed, and of `--merge` for conflicts that remain. */
const CONFLICTS = 1;
const MERGE = "Merge";

/** Pulls a project. Returns whether files may have changed. */
export async function pull(project: Project, transfers: Transfers): Promise<boolean> {
  const transfer = { ...project, title: `Pulling from ${project.address}`, subcommand: "pull" as const, showsOutput: true };
  const finished = await transfers.run({ ...transfer, words: [] });
  if (finished === undefined || finished.code !== CONFLICTS) {
    return finished !== undefined && report(finished, transfers);
  }
  if ((await transfers.showFailure(finished, MERGE)) !== MERGE) {
    return false;
  }
  const merged = await transfers.run({ ...transfer, words: ["--merge"] });
  if (merged?.code !== CONFLICTS) {
    return merged !== undefined && report(merged, transfers);
  }
  void vscode.window.showWarningMessage(`${reason(summaryOf(merged.errors))} Conflicts remain: the output lists the files, `
    + "and states which of them contain both versions, and how to decide on the others.");
  return true;
}

/** Pulls a controller for the first time. Returns the new project. */
export async function pullNew(transfers: Transfers): Promise<Project | undefined> {
  const folder = await chooseFolder();
  const address = folder === undefined ? undefined : await promptForAddress(folder);
  const content = address === undefined ? undefined : await chooseContent();
  if (folder === undefined || address === undefined || content === undefined) {
    return undefined;
  }
  const words = [...content.options, "--", address, "."];
  const finished = await transfers.run({ folder, address, title: `Pulling from ${address}`, subcommand: "pull", words, showsOutput: true });
  const isPulled = finished !== undefined && (await report(finished, transfers));
  return isPulled ? readProject(folder) : undefined;
}

async function report(finished: Finished, transfers: Transfers): Promise<boolean> {
  if (finished.code !== 0) {
    await transfers.showFailure(finished);
    return false;
  }
  void vscode.window.showInformationMessage(reason(summaryOf(finished.errors)));
  return true;
}

async function chooseFolder(): Promise<string | undefined> {
  const folders = localFolders();
  if (folders.length === 0) {
    void vscode.window.showInformationMessage("Open a folder for the files of the controller first.");
  }
  return folders.length < 2 ? folders[0] : vscode.window.showQuickPick(folders, { placeHolder: "The folder for the files of the controller" });
}

async function promptForAddress(folder: string): Promise<string | undefined> {
  const address = await vscode.window.showInputBox({
    title: `Pull from a controller into ${folder}`,
    prompt: "The address of the controller, with a user profile that has readAccess, or the folder of an emulator, which contains usr",
    placeHolder: EXAMPLE,
    ignoreFocusOut: true,
    validateInput: (text) => addressFault(text, folder),
  });
  return address?.trim();
}

interface Content extends vscode.QuickPickItem {
  /** Options of `val3 pull`. */
  options: string[];
}

const CONTENTS: Content[] = [
  { label: "Applications and Settings", detail: "The check and runs use the settings: the arm, inputs and outputs, lines", options: ["--all"] },
  { label: "Applications Only", detail: "The folder usr/usrapp", options: [] },
];

async function chooseContent(): Promise<Content | undefined> {
  return vscode.window.showQuickPick(CONTENTS, { title: "Files to pull", placeHolder: "Select what to pull", ignoreFocusOut: true });
}
