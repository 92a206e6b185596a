// The URIs of code views and of their program files.

import * as vscode from "vscode";

export const SCHEME = "val3-code";

/**
 * The code view of a program. Its tab names the file, and of a file with several programs the program: `pick.pgx (code)`,
 * `two.pgx (second)`. The manifest knows the language of the view by such a path.
 */
export function codeUri(file: vscode.Uri, index = 0, program = "code"): vscode.Uri {
  const path = file.path.replace(/^\/?/, "/");
  const name = `${path.slice(path.lastIndexOf("/") + 1)} (${program})`;
  // Theia cannot show the result of `Uri.from`, which is of another class there.
  const view = vscode.Uri.parse(`${SCHEME}:/`);
  return view.with({ path: `${path}/${name}`, query: file.with({ query: index === 0 ? "" : String(index) }).toString() });
}

/** The file in a command's argument. Other editors pass objects that only look like `vscode.Uri`. */
export function uriOf(value: unknown): vscode.Uri | undefined {
  const isUri = typeof value === "object" && value !== null && "scheme" in value && "path" in value;
  return isUri ? vscode.Uri.parse((value as vscode.Uri).toString()) : undefined;
}

/** The program file of a code view. */
export function fileUri(code: vscode.Uri): vscode.Uri {
  return vscode.Uri.parse(code.query, true).with({ query: "" });
}

/** Which program of its file a code view shows, from 0. */
export function programIndex(code: vscode.Uri): number {
  return Number(vscode.Uri.parse(code.query, true).query);
}
