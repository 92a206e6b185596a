// Lets the user replace the name that a refactoring has made up, in the editor that the user works in.

import * as vscode from "vscode";
import type { Range } from "vscode-languageclient/node";
import type { CodeFiles } from "../codeView/files";
import type { Link } from "../codeView/link";
import { rangeOf } from "../ranges";

export const RENAME = "val3.rename";

/** Milliseconds between two looks at a code view, which follows its file soon, and number of looks. */
const PAUSE = 50;
const LOOKS = 40;

export function registerRename(views: CodeFiles): vscode.Disposable[] {
  return [vscode.commands.registerCommand(RENAME, (uri: string, range: Range) => rename(views, vscode.Uri.parse(uri), range))];
}

async function rename(views: CodeFiles, file: vscode.Uri, range: Range): Promise<void> {
  const active = vscode.window.activeTextEditor?.document.uri;
  const view = active && views.find(active);
  if (view?.file.uri.toString() !== file.toString()) {
    await vscode.commands.executeCommand("editor.action.rename", [file, rangeOf(range).start]);
    return;
  }
  const at = await positionInView(view, range);
  if (at !== undefined) {
    await vscode.commands.executeCommand("editor.action.rename", [view.code, at]);
  }
}

/** Where a view shows a name of its file; nothing if it does not in time. */
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
