// Requests of the tables to the server. Only the page reads their remaining content.

import * as vscode from "vscode";
import type { Position, TextEdit, WorkspaceEdit } from "vscode-languageclient/node";
import type { Client } from "../client";
import { rangeOf } from "../ranges";
import type { DataChanges, DataEdit, DataPose, DataResult, Datum, EditDataResult } from "../serverRequests";

/** Error code of the protocol for a request about a changed text. */
const CONTENT_MODIFIED = -32801;

/** Tables to which changes are applied: the state of the page, without the content that only the page reads. */
export interface Tables {
  resultId: string;
  version: number | null;
  data: readonly Pick<Datum, "name" | "range">[];
}

export class Requests {
  private readonly uri: string;

  constructor(private readonly client: Pick<Client, "request">, uri: vscode.Uri) {
    this.uri = uri.toString();
  }

  /**
   * Requests the changes since an earlier result, or the tables. `null` if the file is not a data file to the server.
   */
  tables(previousResultId: string | undefined, withoutFindings: boolean): Promise<DataResult | null> {
    return this.client.request("val3/data", { uri: this.uri, ...(previousResultId !== undefined && { previousResultId, withoutFindings }) });
  }

  /** Requests an edit. `undefined` if the file has changed meanwhile. */
  async edit(version: number, edits: readonly DataEdit[], check: boolean): Promise<EditDataResult | undefined> {
    try {
      return await this.client.request("val3/editData", { uri: this.uri, version, edits, check });
    } catch (fault) {
      if ((fault as { code?: unknown }).code === CONTENT_MODIFIED) {
        return undefined;
      }
      throw fault;
    }
  }

  poses(names: readonly string[]): Promise<readonly DataPose[]> {
    return this.client.request("val3/dataPoses", { uri: this.uri, names });
  }
}

/** Converts a workspace edit of the protocol without file operations. */
export function workspaceEdit({ changes = {}, documentChanges = [] }: WorkspaceEdit): vscode.WorkspaceEdit {
  const edit = new vscode.WorkspaceEdit();
  const files: [string, TextEdit[]][] = [...Object.entries(changes), ...documentChanges.flatMap(textEdits)];
  for (const [uri, edits] of files) {
    edit.set(vscode.Uri.parse(uri), edits.map(({ range, newText }) => vscode.TextEdit.replace(rangeOf(range), newText)));
  }
  return edit;
}

/** Returns the file and the text edits of a change; file operations have none. */
function textEdits(change: NonNullable<WorkspaceEdit["documentChanges"]>[number]): [string, TextEdit[]][] {
  return "edits" in change ? [[change.textDocument.uri, change.edits.filter((edit) => "newText" in edit)]] : [];
}

export function areChanges(result: DataResult): result is DataChanges {
  return "lineShift" in result;
}

/** Properties of changes that apply to `Tables`. */
export type TableChanges = Pick<DataChanges, "resultId" | "version" | "lineShift"> & { data: Omit<DataChanges["data"], "items"> & { items: Tables["data"] } };

/** Applies changes to tables. */
export function changed({ data }: Tables, { resultId, version, data: { start, deleteCount, items }, lineShift }: TableChanges): Tables {
  const rest = data.slice(start + deleteCount);
  const moved = lineShift === 0 ? rest : rest.map((datum) => ({ ...datum, range: { start: shifted(datum.range.start, lineShift), end: shifted(datum.range.end, lineShift) } }));
  return { resultId, version, data: [...data.slice(0, start), ...items, ...moved] };
}

function shifted({ line, character }: Position, lines: number): Position {
  return { line: line + lines, character };
}

/** Returns the datum at a position: the last one that begins before it. */
export function datumAt({ data }: Tables, { line, character }: Position): string | undefined {
  return data.findLast(({ range: { start } }) => start.line < line || (start.line === line && start.character <= character))?.name;
}
