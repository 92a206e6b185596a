// Read-only documents with files of a controller. They are not read again: the text is that of the last "Show Changes".

import * as vscode from "vscode";
import type { Project } from "./projects";

const SCHEME = "val3-controller";

export class ControllerDocuments implements vscode.TextDocumentContentProvider, vscode.Disposable {
  private readonly changes = new vscode.EventEmitter<vscode.Uri>();
  readonly onDidChange = this.changes.event;
  private readonly texts = new Map<string, string>();
  private readonly registration: vscode.Disposable;

  constructor() {
    this.registration = vscode.Disposable.from(
      vscode.workspace.registerTextDocumentContentProvider(SCHEME, this),
      vscode.workspace.onDidCloseTextDocument(({ uri }) => this.texts.delete(uri.toString())),
    );
  }

  dispose(): void {
    vscode.Disposable.from(this.registration, this.changes).dispose();
  }

  /** Adds or replaces a document. The path determines its language. */
  add({ folder }: Project, path: string, side: "controller" | "absent", text: string): vscode.Uri {
    const uri = vscode.Uri.parse(`${SCHEME}:/`).with({ path: `/${path}`, query: `${side}:${folder}` });
    this.texts.set(uri.toString(), text);
    this.changes.fire(uri);
    return uri;
  }

  /** Throws for a comparison of an earlier window, because nothing is read from a controller without a command. */
  provideTextDocumentContent(uri: vscode.Uri): string {
    const text = this.texts.get(uri.toString());
    if (text === undefined) {
      throw new Error("This comparison was opened in an earlier window. Choose Show Changes in the view Controller.");
    }
    return text;
  }
}
