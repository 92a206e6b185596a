// Code views in which a debug session can show programs.

import * as vscode from "vscode";
import type { CodeFiles } from "../codeView/files";
import { Mapping } from "../codeView/mapping";
import { fileUri, programIndex, SCHEME } from "../codeView/uris";
import { openDocument } from "../encoding/documents";
import type { View, Views } from "./sources";

export class DebugViews implements Views {
  constructor(private readonly files: CodeFiles) {}

  async find(path: string): Promise<View | undefined> {
    if (!path.startsWith(`${SCHEME}:`)) {
      return undefined;
    }
    const code = vscode.Uri.parse(path, true);
    const document = await openDocument(fileUri(code));
    return viewOf(code, document);
  }

  shown(file: string): View[] {
    const uri = vscode.Uri.file(file);
    const links = this.files.of(uri).filter(({ code }) => isShown(code));
    return links.flatMap((link) => viewOf(link.code, link.file) ?? []);
  }
}

function viewOf(code: vscode.Uri, { uri, getText }: Pick<vscode.TextDocument, "uri" | "getText">): View | undefined {
  const mapping = Mapping.of(getText(), programIndex(code));
  const name = code.path.slice(code.path.lastIndexOf("/") + 1);
  return mapping && { code: code.toString(), name, file: uri.fsPath, mapping };
}

/** Whether the code view has a tab. Its document may remain open for a while after the tab was closed. */
function isShown(code: vscode.Uri): boolean {
  const tabs = vscode.window.tabGroups.all.flatMap((group) => group.tabs);
  return tabs.some(({ input }) => input instanceof vscode.TabInputText && input.uri.toString() === code.toString());
}
