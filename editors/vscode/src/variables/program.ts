// The program that the active editor shows, as its file or as its code.

import type * as vscode from "vscode";
import { fileUri, SCHEME } from "../codeView/uris";

/** The file of the program in an editor; nothing if the editor shows something else. */
export function programFile(document: Pick<vscode.TextDocument, "uri" | "languageId"> | undefined): vscode.Uri | undefined {
  if (document?.uri.scheme === SCHEME) {
    return fileUri(document.uri);
  }
  const isProgram = document?.languageId === "val3" && ["file", "untitled"].includes(document.uri.scheme);
  return isProgram ? document.uri : undefined;
}
