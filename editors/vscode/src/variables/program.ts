// Program in the active editor, shown as its file or as its code view.

import type * as vscode from "vscode";
import { fileUri, SCHEME } from "../codeView/uris";

/** Returns the file of the program in an editor; `undefined` if the editor shows something else. */
export function programFile(document: Pick<vscode.TextDocument, "uri" | "languageId"> | undefined): vscode.Uri | undefined {
  if (document?.uri.scheme === SCHEME) {
    return fileUri(document.uri);
  }
  const isProgram = document?.languageId === "val3" && ["file", "untitled"].includes(document.uri.scheme);
  return isProgram ? document.uri : undefined;
}
