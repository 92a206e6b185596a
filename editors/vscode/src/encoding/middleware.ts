// Edits of several files: each file is opened in its own encoding before VS Code opens it in another to change it.

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

/** The edit, once all files that it changes are open. */
export async function withOpenFiles<Edit extends vscode.WorkspaceEdit | null | undefined>(edit: Edit): Promise<Edit> {
  // A file that the edit makes cannot be opened yet.
  await Promise.allSettled((edit?.entries() ?? []).map(([uri]) => openDocument(uri)));
  return edit;
}
