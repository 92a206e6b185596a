// URIs of code views and their program files.

import * as vscode from "vscode";

export const SCHEME = "val3-code";

/**
 * Returns the URI of a program's code view. The tab name contains the file, and for a file with several programs also
 * the program: `pick.pgx (code)`, `two.pgx (second)`. The manifest recognises the view's language by this path.
 */
export function codeUri(file: vscode.Uri, index = 0, program = "code"): vscode.Uri {
  const path = file.path.replace(/^\/?/, "/");
  const name = `${path.slice(path.lastIndexOf("/") + 1)} (${program})`;
  // Theia cannot show the result of `Uri.from`, which has a different class there.
  const view = vscode.Uri.parse(`${SCHEME}:/`);
  return view.with({ path: `${path}/${name}`, query: file.with({ query: index === 0 ? "" : String(index) }).toString() });
}

/** Returns the file in a command's argument. Other editors pass objects that only resemble `vscode.Uri`. */
export function uriOf(value: unknown): vscode.Uri | undefined {
  const isUri = typeof value === "object" && value !== null && "scheme" in value && "path" in value;
  return isUri ? vscode.Uri.parse((value as vscode.Uri).toString()) : undefined;
}

/** Returns the program file of a code view. */
export function fileUri(code: vscode.Uri): vscode.Uri {
  return vscode.Uri.parse(code.query, true).with({ query: "" });
}

/** Returns the index of the program that a code view shows, from 0. */
export function programIndex(code: vscode.Uri): number {
  return Number(vscode.Uri.parse(code.query, true).query);
}
