// Shows breakpoints of a file as rings in its code view, and breakpoints of a code view as rings in its file. VS Code
// shows a breakpoint only in the editor in which it was set, but the run stops at every breakpoint.

import * as vscode from "vscode";
import { Mapping } from "../codeView/mapping";
import { fileUri, programIndex, SCHEME } from "../codeView/uris";
import { lineInCode, type Views } from "./sources";

const LANGUAGES = new Set(["val3", "val3-code"]);

export class OtherBreakpoints implements vscode.Disposable {
  private readonly mark: vscode.TextEditorDecorationType;
  private readonly subscription: vscode.Disposable;

  constructor(private readonly views: Views, icons: vscode.Uri) {
    this.mark = vscode.window.createTextEditorDecorationType({
      gutterIconPath: vscode.Uri.joinPath(icons, "breakpoint.svg"),
      gutterIconSize: "contain",
    });
    const isOwn = ({ languageId }: vscode.TextDocument): boolean => LANGUAGES.has(languageId);
    this.subscription = vscode.Disposable.from(
      vscode.debug.onDidChangeBreakpoints(() => this.show()),
      vscode.window.onDidChangeVisibleTextEditors(() => this.show()),
      vscode.workspace.onDidChangeTextDocument(({ document }) => isOwn(document) && this.show()),
    );
    this.show();
  }

  dispose(): void {
    vscode.Disposable.from(this.subscription, this.mark).dispose();
  }

  private show(): void {
    const places = vscode.debug.breakpoints.flatMap((found) => (found instanceof vscode.SourceBreakpoint ? [found.location] : []));
    for (const editor of vscode.window.visibleTextEditors) {
      const { document } = editor;
      if (LANGUAGES.has(document.languageId)) {
        const own = linesOf(places, document.uri);
        const others = document.uri.scheme === SCHEME ? ofFile(places, document.uri, this.views) : ofViews(places, document);
        const missing = others.filter((line) => !own.includes(line) && line < document.lineCount);
        editor.setDecorations(this.mark, missing.map((line) => document.lineAt(line).range));
      }
    }
  }
}

/** Returns the lines of a document with breakpoints, from 0. */
function linesOf(places: vscode.Location[], uri: vscode.Uri): number[] {
  return places.filter((place) => place.uri.toString() === uri.toString()).map(({ range }) => range.start.line);
}

/** Returns the lines of a code view that have a breakpoint in its file. */
function ofFile(places: vscode.Location[], code: vscode.Uri, views: Views): number[] {
  const file = fileUri(code);
  const view = views.shown(file.fsPath).find((view) => view.code === code.toString());
  const lines = view === undefined ? [] : linesOf(places, file).map((line) => lineInCode(line + 1, view.mapping));
  return lines.flatMap((line) => (line === undefined ? [] : [line - 1]));
}

/** Returns the lines of a file that have a breakpoint in its code views. */
function ofViews(places: vscode.Location[], document: vscode.TextDocument): number[] {
  const inViews = places.filter(({ uri }) => uri.scheme === SCHEME && fileUri(uri).toString() === document.uri.toString());
  return inViews.flatMap(({ uri, range }) => Mapping.of(document.getText(), programIndex(uri))?.toFile(range.start).line ?? []);
}
