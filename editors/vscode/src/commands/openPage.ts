// Opens the page of a finding, an instruction or an error, which the server provides.

import * as vscode from "vscode";
import type { Client } from "../client";

const SCHEME = "val3-page";
const LANGUAGES = ["val3", "val3-data", "val3-project", "val3-code"];

export function registerPages(client: Client): vscode.Disposable[] {
  const pages: vscode.TextDocumentContentProvider = { provideTextDocumentContent: (uri) => page(client, uri) };
  return [
    vscode.workspace.registerTextDocumentContentProvider(SCHEME, pages),
    vscode.commands.registerCommand("val3.openPage", openPage),
    vscode.languages.registerCodeActionsProvider(LANGUAGES, {
      provideCodeActions: (_document, _range, { diagnostics }) => [...new Set(diagnostics.flatMap(codeOf))].map(pageAction),
    }),
  ];
}

async function page(client: Client, uri: vscode.Uri): Promise<string> {
  const topic = uri.path.replace(/\.md$/, "");
  const page = await client.request("val3/page", { topic });
  return page?.markdown ?? `There is no page about \`${topic}\`.`;
}

/** Opens the page of `code`, of a finding at the cursor, or of a topic that the user enters. */
async function openPage(code?: string): Promise<void> {
  const topic = code ?? (await chosen());
  if (topic !== undefined) {
    await vscode.commands.executeCommand("markdown.showPreview", vscode.Uri.parse(`${SCHEME}:/`).with({ path: `${topic}.md` }));
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
    return vscode.window.showInputBox({ prompt: "A finding (V0203), an instruction, a type, a field, another word or a run-time error" });
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
