// The page of a finding, as `val3 explain` prints it.

import { execFile } from "node:child_process";
import { promisify } from "node:util";
import * as vscode from "vscode";
import type { Client } from "../client";

const SCHEME = "val3-page";

export function registerPages(client: Client): vscode.Disposable[] {
  const pages: vscode.TextDocumentContentProvider = { provideTextDocumentContent: (uri) => page(client, uri) };
  return [
    vscode.workspace.registerTextDocumentContentProvider(SCHEME, pages),
    vscode.commands.registerCommand("val3.openPage", openPage),
    vscode.languages.registerCodeActionsProvider([{ language: "val3" }, { language: "val3-data" }, { language: "val3-project" }, { language: "val3-code" }], {
      provideCodeActions: (_document, _range, { diagnostics }) => [...new Set(diagnostics.flatMap(codeOf))].map(pageAction),
    }),
  ];
}

async function page(client: Client, uri: vscode.Uri): Promise<string> {
  const topic = uri.path.replace(/\.md$/, "");
  const { stdout } = await promisify(execFile)(client.command ?? "val3", ["--color", "never", "explain", topic]);
  return stdout;
}

/** Opens the page of `code`, or of a finding under the cursor, or of the one that is chosen. */
async function openPage(code?: string): Promise<void> {
  const topic = code ?? (await chosen());
  if (topic !== undefined) {
    await vscode.commands.executeCommand("markdown.showPreview", vscode.Uri.from({ scheme: SCHEME, path: `${topic}.md` }));
  }
}

async function chosen(): Promise<string | undefined> {
  const editor = vscode.window.activeTextEditor;
  const all = editor === undefined ? [] : vscode.languages.getDiagnostics(editor.document.uri);
  const here = all.filter((diagnostic) => editor?.selection.intersection(diagnostic.range) !== undefined);
  const choices = (here.length > 0 ? here : all).flatMap((diagnostic) =>
    codeOf(diagnostic).map((label) => ({ label, description: diagnostic.message })),
  );
  if (choices.length === 0) {
    return vscode.window.showInputBox({ prompt: "A finding (V0203), an instruction, a statement or a run-time error" });
  }
  const codes = new Set(choices.map(({ label }) => label));
  return codes.size === 1 ? choices[0]?.label : (await vscode.window.showQuickPick(choices))?.label;
}

function codeOf({ source, code }: vscode.Diagnostic): string[] {
  const value = typeof code === "object" ? code.value : code;
  return source?.startsWith("val3") === true && value !== undefined ? [String(value)] : [];
}

function pageAction(code: string): vscode.CodeAction {
  const action = new vscode.CodeAction(`Open the page of ${code}`, vscode.CodeActionKind.Empty);
  action.command = { command: "val3.openPage", title: "Open", arguments: [code] };
  return action;
}
