// Renames and deletes items of the view, and finds their uses.

import * as vscode from "vscode";
import type { Location, TextDocumentPositionParams, WorkspaceEdit } from "vscode-languageclient/node";
import type { Client } from "../client";
import { SHOW_REFERENCES } from "../commands/showReferences";
import { openDocument } from "../encoding/documents";
import { rangeOf } from "../ranges";
import type { Item } from "./graph";
import type { TreeNode } from "./nodes";

export async function rename(client: Client, { item, label }: TreeNode): Promise<void> {
  const at = item && (await place(item));
  if (at === undefined) {
    return;
  }
  await client.request("textDocument/prepareRename", at);
  const renamed = (newName: string): Promise<WorkspaceEdit> => client.request("textDocument/rename", { ...at, newName });
  const newName = await vscode.window.showInputBox({
    prompt: `The new name of ${label}`,
    value: label,
    validateInput: (newName) => (newName === label ? undefined : renamed(newName).then(() => undefined, reason)),
  });
  if (newName !== undefined && newName !== label) {
    await apply(client, await renamed(newName));
  }
}

const DELETE = "Delete";
const SHOW_USES = "Show Uses";

export async function remove(client: Client, { item, label, context }: TreeNode): Promise<void> {
  const at = item && (await place(item));
  if (at === undefined) {
    return;
  }
  const { edit, uses } = await client.request("val3/delete", at);
  const what = context.includes("program") ? "program" : context.includes("data") ? "data" : "entry";
  const count = uses.length === 1 ? "1 place uses" : `${uses.length} places use`;
  const detail = uses.length === 0 ? "Nothing uses it." : `${count} it and will have an error.`;
  const buttons = uses.length === 0 ? [DELETE] : [DELETE, SHOW_USES];
  const choice = await vscode.window.showWarningMessage(`Delete the ${what} ${label}?`, { modal: true, detail }, ...buttons);
  if (choice === DELETE) {
    await apply(client, edit);
  } else if (choice === SHOW_USES) {
    await show(at, uses);
  }
}

export async function findUses(client: Client, { item, label }: TreeNode): Promise<void> {
  const at = item && (await place(item));
  if (at === undefined) {
    return;
  }
  const uses = await client.request("textDocument/references", { ...at, context: { includeDeclaration: false } });
  if (uses === null || uses.length === 0) {
    void vscode.window.showInformationMessage(`Nothing uses ${label}.`);
  } else {
    await show(at, uses);
  }
}

async function show({ textDocument, position }: TextDocumentPositionParams, uses: readonly Location[]): Promise<void> {
  await vscode.commands.executeCommand(SHOW_REFERENCES, textDocument.uri, position, uses);
}

/** Applies an edit from the server, and saves the files if the setting requires it. */
export async function apply(client: Client, edit: WorkspaceEdit): Promise<void> {
  const converted = await client.workspaceEdit(edit);
  const uris = new Set(converted.entries().map(([uri]) => uri.toString()));
  const unchanged = vscode.workspace.textDocuments.filter(({ uri, isDirty }) => uris.has(uri.toString()) && !isDirty);
  if (!(await vscode.workspace.applyEdit(converted, { isRefactoring: true }))) {
    throw new Error("The files could not be changed.");
  }
  // VS Code itself saves only changes of several files.
  if (vscode.workspace.getConfiguration("files").get<boolean>("refactoring.autoSave", true)) {
    await Promise.all(unchanged.filter(({ isDirty, isClosed }) => isDirty && !isClosed).map((document) => document.save()));
  }
}

/**
 * Returns the position of the name, if the file still contains it there. The file may have been edited since the view
 * was filled.
 */
async function place({ name, location: { uri, range } }: Item): Promise<TextDocumentPositionParams> {
  const document = await openDocument(vscode.Uri.parse(uri));
  // Some entries list a program by its file.
  if (document.getText(rangeOf(range)) !== name) {
    throw new Error(`${name} has just been changed. Refresh the view, and try again.`);
  }
  return { textDocument: { uri }, position: range.start };
}

/** Formats an error message as a sentence. */
export function reason(fault: unknown): string {
  const text = fault instanceof Error ? fault.message : String(fault);
  const sentence = text.charAt(0).toUpperCase() + text.slice(1);
  return /[.!?]$/.test(sentence) ? sentence : `${sentence}.`;
}
