// Requests of the tables to the server. Only the page reads their remaining content.

import * as vscode from "vscode";
import type { Client } from "../client";
import { rangeOf } from "../ranges";

/** Error code of the protocol for a request about a changed text. */
const CONTENT_MODIFIED = -32801;

interface Position {
  line: number;
  character: number;
}

export interface Range {
  start: Position;
  end: Position;
}

interface Datum {
  name: string;
  range: Range;
}

export interface Tables {
  resultId: string;
  version: number | null;
  data: Datum[];
}

/** Replacement of items in a list. */
interface Replacement<Item> {
  start: number;
  deleteCount: number;
  items: Item[];
}

/** Difference between the tables and an earlier result. */
export interface Changes {
  resultId: string;
  version: number | null;
  data: Replacement<Datum>;
  /** Number to add to the lines of all data after the replaced ones. */
  lineShift: number;
}

interface TextEdit {
  range: Range;
  newText: string;
}

/** Workspace edit of the protocol, without file operations. */
export interface ProtocolEdit {
  changes?: Record<string, TextEdit[]>;
  documentChanges?: { textDocument: { uri: string }; edits: TextEdit[] }[];
}

export interface EditAnswer {
  edit: ProtocolEdit | null;
  refused: string | null;
  findings: unknown[];
}

export class Requests {
  private readonly uri: string;

  constructor(private readonly client: Pick<Client, "request">, uri: vscode.Uri) {
    this.uri = uri.toString();
  }

  /**
   * Requests the changes since an earlier result, or the tables. `null` if the file is not a data file to the server.
   */
  tables(previousResultId: string | undefined, withoutFindings: boolean): Promise<Tables | Changes | null> {
    return this.client.request("val3/data", { uri: this.uri, ...(previousResultId !== undefined && { previousResultId, withoutFindings }) });
  }

  /** Requests an edit. `undefined` if the file has changed meanwhile. */
  async edit(version: number, edits: unknown, check: boolean): Promise<EditAnswer | undefined> {
    try {
      return await this.client.request<EditAnswer>("val3/editData", { uri: this.uri, version, edits, check });
    } catch (fault) {
      if ((fault as { code?: unknown }).code === CONTENT_MODIFIED) {
        return undefined;
      }
      throw fault;
    }
  }

  poses(names: unknown): Promise<unknown> {
    return this.client.request("val3/dataPoses", { uri: this.uri, names });
  }
}

export function workspaceEdit({ changes = {}, documentChanges = [] }: ProtocolEdit): vscode.WorkspaceEdit {
  const edit = new vscode.WorkspaceEdit();
  const files: [string, TextEdit[]][] = [...Object.entries(changes), ...documentChanges.map(({ textDocument: { uri }, edits }): [string, TextEdit[]] => [uri, edits])];
  for (const [uri, edits] of files) {
    edit.set(vscode.Uri.parse(uri), edits.map(({ range, newText }) => vscode.TextEdit.replace(rangeOf(range), newText)));
  }
  return edit;
}

export function areChanges(result: Tables | Changes): result is Changes {
  return "lineShift" in result;
}

/** Applies changes to tables. */
export function changed({ data }: Tables, { resultId, version, data: { start, deleteCount, items }, lineShift }: Changes): Tables {
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
