// Opens the files that an edit changes in their own encodings, before VS Code opens them in the default encoding.

import type * as vscode from "vscode";
import type { Middleware } from "vscode-languageclient/node";
import { openDocument } from "./documents";

export const encodingMiddleware: Middleware = {
  provideRenameEdits: async (document, position, name, token, next) => withOpenFiles(await next(document, position, name, token)),
  resolveCodeAction: async (action, token, next) => {
    const resolved = await next(action, token);
    await withOpenFiles(resolved?.edit);
    return resolved;
  },
};

/** Returns the edit once all files that it changes are open. */
export async function withOpenFiles<Edit extends vscode.WorkspaceEdit | null | undefined>(edit: Edit): Promise<Edit> {
  // A file that the edit creates cannot be opened yet.
  await Promise.allSettled((edit?.entries() ?? []).map(([uri]) => openDocument(uri)));
  return edit;
}
