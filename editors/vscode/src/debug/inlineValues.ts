// Values of variables in the code while the application is stopped. The language server says what is a variable.

import * as vscode from "vscode";
import { expressions, firstLineOfCode } from "./variables";

const LANGUAGES = ["val3", "val3-code"];

export function registerInlineValues(): vscode.Disposable[] {
  return LANGUAGES.map((language) => vscode.languages.registerInlineValuesProvider({ language }, { provideInlineValues }));
}

async function provideInlineValues(
  document: vscode.TextDocument,
  viewPort: vscode.Range,
  { stoppedLocation }: vscode.InlineValueContext,
): Promise<vscode.InlineValue[]> {
  const [legend, tokens] = await Promise.all([
    vscode.commands.executeCommand<vscode.SemanticTokensLegend | undefined>("vscode.provideDocumentSemanticTokensLegend", document.uri),
    vscode.commands.executeCommand<vscode.SemanticTokens | undefined>("vscode.provideDocumentSemanticTokens", document.uri),
  ]);
  // Lines that follow have not been executed, so that their values would be wrong.
  const last = stoppedLocation.end.line;
  const first = firstLineOfCode((line) => document.lineAt(line).text, last);
  const lines = { first: Math.max(first, viewPort.start.line), last };
  const found = legend === undefined || tokens === undefined ? [] : expressions(tokens.data, legend.tokenTypes, lines, textOf(document));
  return found.map(({ line, start, end, text }) => new vscode.InlineValueEvaluatableExpression(new vscode.Range(line, start, line, end), text));
}

function textOf(document: vscode.TextDocument): (line: number, start: number, end: number) => string {
  return (line, start, end) => document.lineAt(line).text.slice(start, end);
}
