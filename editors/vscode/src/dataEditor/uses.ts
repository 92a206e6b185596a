// Locations that use data, for the confirmation before data are deleted.

import * as vscode from "vscode";
import { openDocument } from "../encoding/documents";
import { rangeOf } from "../ranges";
import type { Tables } from "./requests";

export interface Use {
  name: string;
  file: string;
  uri: string;
  line: number;
  character: number;
  text: string;
}

/** Returns the uses outside the declarations, by name. */
export async function usesOf(uri: vscode.Uri, { data }: Tables, names: readonly string[]): Promise<Use[]> {
  const wanted = data.filter(({ name }) => names.includes(name));
  return (await Promise.all(wanted.map(async ({ name, range }) => {
    const start = rangeOf(range).start;
    const found = await vscode.commands.executeCommand<vscode.Location[] | undefined>("vscode.executeReferenceProvider", uri, start);
    const uses = (found ?? []).filter((location) => location.uri.toString() !== uri.toString() || !location.range.start.isEqual(start));
    return Promise.all(uses.map((location) => useOf(name, location)));
  }))).flat();
}

async function useOf(name: string, { uri, range: { start } }: vscode.Location): Promise<Use> {
  const document = await openDocument(uri);
  const { text } = document.lineAt(start);
  return { name, file: vscode.workspace.asRelativePath(uri), uri: uri.toString(), line: start.line, character: start.character, text: text.trim() };
}

export async function openUse({ uri, line, character }: Use): Promise<void> {
  const at = new vscode.Position(line, character);
  await vscode.window.showTextDocument(vscode.Uri.parse(uri), { selection: new vscode.Range(at, at), viewColumn: vscode.ViewColumn.Beside });
}
