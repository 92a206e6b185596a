// Applies changes in the tables to the file's document, one after the other.

import * as vscode from "vscode";
import { openDocument } from "../encoding/documents";
import { withOpenFiles } from "../encoding/middleware";
import type { DataEdit, EditDataResult } from "../serverRequests";
import { type Requests, workspaceEdit } from "./requests";

/** Edit result for the page. */
export type Outcome = Pick<EditDataResult, "refused" | "findings">;

/** Largest number of attempts, in case the user types in the same file meanwhile. */
const ATTEMPTS = 5;

export class Edits {
  private turn: Promise<unknown> = Promise.resolve();

  constructor(private readonly document: vscode.TextDocument, private readonly requests: Requests) {}

  /** Computes an edit for the present text and applies it. */
  apply(edits: readonly DataEdit[]): Promise<Outcome> {
    const outcome = this.turn.then(() => this.attempt(edits, false));
    this.turn = outcome.catch(() => undefined);
    return outcome;
  }

  /** Returns the findings that an edit would add. */
  check(edits: readonly DataEdit[]): Promise<Outcome> {
    return this.attempt(edits, true);
  }

  /** Renames a datum in all files, like F2 in the text. */
  async rename(position: vscode.Position, as: string): Promise<Outcome> {
    try {
      const edit = await vscode.commands.executeCommand<vscode.WorkspaceEdit>("vscode.executeDocumentRenameProvider", this.document.uri, position, as);
      return outcomeOf(await vscode.workspace.applyEdit(await withOpenFiles(edit)));
    } catch (fault) {
      return { refused: fault instanceof Error ? fault.message : String(fault), findings: [] };
    }
  }

  private async attempt(edits: readonly DataEdit[], check: boolean): Promise<Outcome> {
    // A file that was read in the wrong encoding is read again first, because an edit would make lost characters permanent.
    await openDocument(this.document.uri);
    for (let attempt = 0; attempt < ATTEMPTS; attempt += 1) {
      const { version } = this.document;
      const answer = await this.requests.edit(version, edits, check);
      if (answer !== undefined && (check || answer.edit === null)) {
        return { refused: answer.refused, findings: answer.findings };
      } else if (answer?.edit && this.document.version === version) {
        return outcomeOf(await vscode.workspace.applyEdit(workspaceEdit(answer.edit)));
      }
    }
    return { refused: "The text of the file is being changed. Try again.", findings: [] };
  }
}

function outcomeOf(isApplied: boolean): Outcome {
  return { refused: isApplied ? null : "The editor has not applied the change. The file may be read-only.", findings: [] };
}
