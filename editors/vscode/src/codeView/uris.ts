// A code view and its program file name each other.

import * as vscode from "vscode";

export const SCHEME = "val3-code";

/** The code view of a program; of a file with several programs each has its own, named after it. */
export function codeUri(file: vscode.Uri, index = 0, program?: string): vscode.Uri {
  const stem = file.path.replace(/^\/?/, "/").replace(/\.pgx$/i, "");
  const path = program === undefined ? `${stem}.val3` : `${stem}/${program}.val3`;
  return vscode.Uri.from({ scheme: SCHEME, path, query: file.with({ query: index === 0 ? "" : String(index) }).toString() });
}

/** The program file of a code view. */
export function fileUri(code: vscode.Uri): vscode.Uri {
  return vscode.Uri.parse(code.query, true).with({ query: "" });
}

/** Which program of its file a code view shows, from 0. */
export function programIndex(code: vscode.Uri): number {
  return Number(vscode.Uri.parse(code.query, true).query);
}
