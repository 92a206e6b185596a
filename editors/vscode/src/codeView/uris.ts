// A code view and its program file name each other.

import * as vscode from "vscode";

export const SCHEME = "val3-code";

/** The code view of a program file. */
export function codeUri(file: vscode.Uri): vscode.Uri {
  const path = file.path.replace(/(\.pgx)?$/i, ".val3");
  return vscode.Uri.from({ scheme: SCHEME, path: path.startsWith("/") ? path : `/${path}`, query: file.toString() });
}

/** The program file of a code view. */
export function fileUri(code: vscode.Uri): vscode.Uri {
  return vscode.Uri.parse(code.query, true);
}
