// Switches between a program file and its code view, and keeps the cursor position.

import * as vscode from "vscode";
import { openDocument } from "../encoding/documents";
import type { CodeFiles } from "./files";
import { programUri } from "./follow";
import { Mapping, type Position } from "./mapping";
import { type Program, programsOf } from "./projection";
import { APPLY_EDITS } from "./requests";
import { fileUri, SCHEME, uriOf } from "./uris";
import type { Walkthrough } from "../walkthrough";

export function registerCodeView(views: CodeFiles, walkthrough: Walkthrough): vscode.Disposable[] {
  return [
    vscode.commands.registerCommand("val3.openCode", async (target?: vscode.Uri | TreeNode) => {
      if (await openCode(target)) {
        walkthrough.done("code");
      }
    }),
    vscode.commands.registerCommand("val3.openFile", () => openFile(views)),
    vscode.commands.registerCommand(APPLY_EDITS, applyEdits),
  ];
}

/** Item of the view "VAL 3" for a program. */
interface TreeNode {
  item: vscode.TreeItem;
}

/** Returns whether a code view was opened. */
async function openCode(target?: vscode.Uri | TreeNode): Promise<boolean> {
  const editor = vscode.window.activeTextEditor;
  const item = target !== undefined && "item" in target ? target.item : undefined;
  const file = uriOf(item?.resourceUri ?? target) ?? (await programFile(editor));
  if (file === undefined || file.scheme === SCHEME) {
    return false;
  }
  const document = await openDocument(file);
  const text = document.getText();
  const cursor = editor?.document === document ? editor.selection.active : undefined;
  const programs = programsOf(text);
  const index = await chooseProgram(programs, programs.findIndex(({ name }) => name === item?.label), cursor && document.offsetAt(cursor));
  if (programs.length === 0) {
    void vscode.window.showWarningMessage(`${vscode.workspace.asRelativePath(file)} has no element <Code>.`);
  } else if (index !== undefined) {
    await show(programUri(file, text, index), cursor && Mapping.of(text, index)?.toCode(cursor));
  }
  return index !== undefined;
}

/** Returns the program in the editor, or a program that the user selects. */
async function programFile(editor: vscode.TextEditor | undefined): Promise<vscode.Uri | undefined> {
  if (editor?.document.languageId === "val3") {
    return editor.document.uri;
  }
  const files = await vscode.workspace.findFiles("**/*.{pgx,PGX}");
  const items = files.map((uri) => ({ label: vscode.workspace.asRelativePath(uri), uri }));
  items.sort((left, right) => left.label.localeCompare(right.label));
  return (await vscode.window.showQuickPick(items, { placeHolder: "Program whose code is shown", ignoreFocusOut: true }))?.uri;
}

/** Returns the index of a program: the only one, the requested one, or one that the user selects. */
async function chooseProgram(programs: Program[], wanted: number, cursor?: number): Promise<number | undefined> {
  if (programs.length < 2 || wanted >= 0) {
    return programs.length === 1 ? 0 : wanted >= 0 ? wanted : undefined;
  }
  const here = cursor === undefined ? -1 : programs.findLastIndex(({ tagStart }) => tagStart <= cursor);
  const items = programs.map(({ name }, index) => ({ label: name, index }));
  // The program with the cursor is first, so that Enter selects it.
  items.sort((left, right) => Number(right.index === here) - Number(left.index === here));
  return (await vscode.window.showQuickPick(items, { placeHolder: "Program of this file whose code is shown" }))?.index;
}

async function openFile(views: CodeFiles): Promise<void> {
  const editor = vscode.window.activeTextEditor;
  if (editor?.document.uri.scheme === SCHEME) {
    const link = views.find(editor.document.uri);
    await link?.settled();
    await show(fileUri(editor.document.uri), link?.mapping()?.toFile(editor.selection.active));
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

async function applyEdits(uri: string, edits: ProtocolEdit[], then?: { command: string; arguments?: unknown[] }): Promise<void> {
  const edit = new vscode.WorkspaceEdit();
  for (const { range: { start, end }, newText } of edits) {
    edit.replace(vscode.Uri.parse(uri), new vscode.Range(start.line, start.character, end.line, end.character), newText);
  }
  await vscode.workspace.applyEdit(edit);
  if (then !== undefined) {
    await vscode.commands.executeCommand(then.command, ...(then.arguments ?? []));
  }
}
