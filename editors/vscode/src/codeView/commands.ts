// From a program file to its code view and back, with the cursor where it was.

import * as vscode from "vscode";
import type { CodeFiles } from "./files";
import { Mapping, type Position } from "./mapping";
import { APPLY_EDITS } from "./requests";
import { codeUri, fileUri, SCHEME } from "./uris";

export function registerCodeView(views: CodeFiles): vscode.Disposable[] {
  return [
    vscode.commands.registerCommand("val3.openCode", (target?: vscode.Uri | TreeNode) => openCode(target)),
    vscode.commands.registerCommand("val3.openFile", () => openFile(views)),
    vscode.commands.registerCommand(APPLY_EDITS, applyEdits),
  ];
}

/** A line of the view "VAL 3". */
interface TreeNode {
  item: vscode.TreeItem;
}

async function openCode(target?: vscode.Uri | TreeNode): Promise<void> {
  const editor = vscode.window.activeTextEditor;
  const file = (target instanceof vscode.Uri ? target : target?.item.resourceUri) ?? editor?.document.uri;
  if (file === undefined || file.scheme === SCHEME) {
    return;
  }
  const document = await vscode.workspace.openTextDocument(file);
  const mapping = Mapping.of(document);
  if (mapping === undefined) {
    void vscode.window.showWarningMessage(`${vscode.workspace.asRelativePath(file)} has no element <Code>.`);
    return;
  }
  const isShown = editor?.document === document;
  await show(codeUri(file), isShown ? mapping.toCode(editor.selection.active) : undefined);
}

async function openFile(views: CodeFiles): Promise<void> {
  const editor = vscode.window.activeTextEditor;
  const uri = editor?.document.uri;
  if (uri?.scheme === SCHEME) {
    await views.find(uri)?.settled();
    await show(fileUri(uri), views.find(uri)?.mapping()?.toFile(editor!.selection.active));
  }
}

async function show(uri: vscode.Uri, cursor: Position | undefined): Promise<void> {
  const at = cursor && new vscode.Position(cursor.line, cursor.character);
  await vscode.window.showTextDocument(uri, { preview: false, ...(at && { selection: new vscode.Range(at, at) }) });
}

interface ProtocolEdit {
  range: { start: Position; end: Position };
  newText: string;
}

async function applyEdits(uri: string, edits: ProtocolEdit[]): Promise<void> {
  const edit = new vscode.WorkspaceEdit();
  for (const { range: { start, end }, newText } of edits) {
    edit.replace(vscode.Uri.parse(uri), new vscode.Range(start.line, start.character, end.line, end.character), newText);
  }
  await vscode.workspace.applyEdit(edit);
}
