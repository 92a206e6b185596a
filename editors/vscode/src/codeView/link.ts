// Keeps the documents of a code view and its file in sync.
//
// Edits are executed one after the other. While an edit of the code is being applied to the file, the file is older
// than the code on the screen, so the code has priority. At all other times the file has priority.

import * as vscode from "vscode";
import { openDocument } from "../encoding/documents";
import { Mapping } from "./mapping";
import { difference, Projection } from "./projection";
import { fileUri, programIndex } from "./uris";

export class Link {
  private readonly index: number;
  private pending = 0;
  private queue: Promise<unknown> = Promise.resolve();
  /** Modification time in ms; increases with each change that VS Code has to read. */
  changed = Date.now();

  private constructor(
    readonly code: vscode.Uri,
    readonly file: vscode.TextDocument,
    private readonly reload: (code: vscode.Uri) => void,
  ) {
    this.index = programIndex(code);
  }

  /** Opens the file of a code view. Throws if it does not exist. */
  static async open(code: vscode.Uri, reload: (code: vscode.Uri) => void): Promise<Link> {
    return new Link(code, await openDocument(fileUri(code)), reload);
  }

  /** Returns the code of the file; `undefined` if it contains none. */
  text(): string | undefined {
    return Projection.of(this.file.getText(), this.index)?.code;
  }

  mapping(): Mapping | undefined {
    return Mapping.of(this.file.getText(), this.index);
  }

  /** Resolves when all previous edits of the code are in the file. */
  async settled(): Promise<void> {
    await this.queue;
  }

  /** Queues an edit that writes the document's present code into the file. */
  async push(text?: string): Promise<void> {
    this.pending += 1;
    const run = this.queue.then(() => this.write(text ?? this.document()?.getText())).finally(() => (this.pending -= 1));
    this.queue = run.catch(() => undefined);
    await run;
  }

  /** Saves the file. */
  async save(): Promise<void> {
    if (this.file.isDirty && !(await this.file.save())) {
      throw vscode.FileSystemError.NoPermissions(this.file.uri);
    }
    this.changed = Math.max(Date.now(), this.changed + 1);
  }

  /**
   * Updates the view after a change of the file. A clean view is read again; a view with unsaved changes gets the
   * difference.
   */
  async pull(): Promise<void> {
    const document = this.document();
    const text = this.text();
    if (this.pending > 0 || document === undefined || text === undefined) {
      return;
    }
    const change = difference(document.getText(), withLineEnds(text, document.eol));
    if (change === undefined) {
      return;
    }
    if (document.isDirty) {
      await replace(document, change.start, change.end, change.text);
    } else {
      this.changed = Math.max(Date.now(), this.changed + 1);
      this.reload(this.code);
    }
  }

  document(): vscode.TextDocument | undefined {
    return vscode.workspace.textDocuments.find((document) => document.uri.toString() === this.code.toString());
  }

  private async write(text: string | undefined): Promise<void> {
    const projection = Projection.of(this.file.getText(), this.index);
    if (text === undefined || projection === undefined) {
      return;
    }
    const change = projection.replacement(withLineEnds(text, this.file.eol));
    if (change !== undefined && !(await replace(this.file, change.start, change.end, change.text))) {
      throw vscode.FileSystemError.Unavailable(this.file.uri);
    }
  }
}

function withLineEnds(text: string, eol: vscode.EndOfLine): string {
  return text.replace(/\r\n|\n/g, eol === vscode.EndOfLine.CRLF ? "\r\n" : "\n");
}

async function replace(document: vscode.TextDocument, start: number, end: number, text: string): Promise<boolean> {
  const edit = new vscode.WorkspaceEdit();
  edit.replace(document.uri, new vscode.Range(document.positionAt(start), document.positionAt(end)), text);
  return vscode.workspace.applyEdit(edit);
}
