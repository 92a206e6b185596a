// "Add Library" and "Add Type": the choice of a project in the cell, and its entry in the `.pjx`.

import * as vscode from "vscode";
import type { WorkspaceEdit } from "vscode-languageclient/node";
import type { Client } from "../client";
import type { LibraryKind, TreeProject } from "../serverRequests";
import { type Choice, sections } from "./candidates";
import { apply, reason } from "./changes";

export async function addReference(client: Client, { name, uri }: TreeProject, kind: LibraryKind): Promise<void> {
  const { candidates } = await client.request("val3/libraries", { uri });
  const items = sections(candidates, kind).flatMap(({ heading, choices }): (vscode.QuickPickItem | Choice)[] => [
    { label: heading, kind: vscode.QuickPickItemKind.Separator },
    ...choices,
  ]);
  const what = kind === "type" ? "user type" : "library";
  if (items.length === 0) {
    void vscode.window.showInformationMessage(`The cell has no ${what} for ${name}.`);
    return;
  }
  const options = { placeHolder: `The ${what} for ${name}`, matchOnDescription: true, matchOnDetail: true };
  const chosen = await vscode.window.showQuickPick(items, options);
  if (chosen !== undefined && "candidate" in chosen) {
    await addAs(client, uri, kind, chosen);
  }
}

/** Prompts for the name, which the server checks, and adds the entry. */
async function addAs(client: Client, uri: string, kind: LibraryKind, { candidate, label }: Choice): Promise<void> {
  const request = (name: string): Promise<WorkspaceEdit> =>
    client.request("val3/addLibrary", { uri, kind, name, path: candidate.path });
  // A circular reference and a project file with errors are rejected before the prompt.
  await request(candidate.name);
  const name = await vscode.window.showInputBox({
    prompt: kind === "type" ? `The name of the type ${label}` : `The identifier of the library ${label}`,
    value: candidate.name,
    validateInput: (name) => request(name).then(() => undefined, reason),
  });
  if (name !== undefined) {
    await apply(client, await request(name));
  }
}
