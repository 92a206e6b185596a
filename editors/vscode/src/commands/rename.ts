// After a refactoring: starts a rename of the new name, or selects the new condition, in the active editor.

import * as vscode from "vscode";
import type { Range } from "vscode-languageclient/node";
import type { CodeFiles } from "../codeView/files";
import type { Link } from "../codeView/link";
import { rangeOf } from "../ranges";

export const RENAME = "val3.rename";
export const SELECT = "val3.select";

/** Milliseconds between two checks whether a code view is in sync with its file, and number of checks. */
const PAUSE = 50;
const LOOKS = 40;

export function registerRename(views: CodeFiles): vscode.Disposable[] {
  return [
    vscode.commands.registerCommand(RENAME, (uri: string, range: Range) => rename(views, vscode.Uri.parse(uri), range)),
    vscode.commands.registerCommand(SELECT, (uri: string, range: Range) => select(views, vscode.Uri.parse(uri), range)),
  ];
}

async function rename(views: CodeFiles, file: vscode.Uri, range: Range): Promise<void> {
  const at = await shownAt(views, file, range);
  if (at !== undefined) {
    await vscode.commands.executeCommand("editor.action.rename", [at.uri, at.position]);
  }
}

/** Selects a text within a line, so that typing replaces it. */
async function select(views: CodeFiles, file: vscode.Uri, range: Range): Promise<void> {
  const at = await shownAt(views, file, range);
  const editor = vscode.window.activeTextEditor;
  if (at !== undefined && editor?.document.uri.toString() === at.uri.toString()) {
    editor.selection = new vscode.Selection(at.position, at.position.translate(0, range.end.character - range.start.character));
  }
}

/** Returns the location in the active editor for a location in a file: in the file, or in its code view. */
async function shownAt(views: CodeFiles, file: vscode.Uri, range: Range): Promise<{ uri: vscode.Uri; position: vscode.Position } | undefined> {
  const active = vscode.window.activeTextEditor?.document.uri;
  const view = active && views.find(active);
  if (view?.file.uri.toString() !== file.toString()) {
    return { uri: file, position: rangeOf(range).start };
  }
  const position = await positionInView(view, range);
  return position && { uri: view.code, position };
}

/** Returns the position where a view shows a text of the file; `undefined` if the view is not updated in time. */
async function positionInView(view: Link, range: Range): Promise<vscode.Position | undefined> {
  const name = view.file.getText(rangeOf(range));
  for (let look = 0; look < LOOKS; look += 1) {
    const at = view.mapping()?.toCode(range.start);
    if (at !== undefined && view.document()?.lineAt(at.line).text.startsWith(name, at.character) === true) {
      return new vscode.Position(at.line, at.character);
    }
    await new Promise((resolve) => setTimeout(resolve, PAUSE));
  }
  return undefined;
}
