// Opens another code view for *Go to Definition* in a code view, instead of the XML file.

import * as vscode from "vscode";
import { openDocument } from "../encoding/documents";
import type { Range } from "./mapping";
import { placeInCode } from "./place";
import { programsOf } from "./projection";
import { codeUri } from "./uris";

export const FOLLOWED = new Set([
  "textDocument/definition",
  "textDocument/declaration",
  "textDocument/typeDefinition",
  "textDocument/implementation",
]);

interface Target {
  uri?: string;
  range?: Range;
  targetUri?: string;
  targetRange?: Range;
  targetSelectionRange?: Range;
}

/** Converts the response to one of these requests: locations in files with a code view become locations in the view. */
export async function inCodeViews(answer: unknown): Promise<unknown> {
  if (answer === null || typeof answer !== "object" || !vscode.workspace.getConfiguration("val3").get<boolean>("codeView.follow", true)) {
    return answer;
  }
  const targets = [answer].flat() as Target[];
  return Promise.all(targets.map(follow));
}

async function follow(target: Target): Promise<Target> {
  const uri = vscode.Uri.parse(target.targetUri ?? target.uri ?? "", true);
  const range = target.targetSelectionRange ?? target.range;
  if (!/\.pgx$/i.test(uri.path) || uri.scheme !== "file" || range === undefined) {
    return target;
  }
  const text = (await openDocument(uri)).getText();
  const place = placeInCode(text, range);
  if (place === undefined) {
    return target;
  }
  const code = programUri(uri, text, place.index).toString();
  return target.targetUri === undefined
    ? { uri: code, range: place.range }
    : { ...target, targetUri: code, targetRange: place.range, targetSelectionRange: place.range };
}

/** Returns the URI of the code view for a program in the file. */
export function programUri(file: vscode.Uri, text: string, index: number): vscode.Uri {
  const programs = programsOf(text);
  return codeUri(file, index, programs.length > 1 ? programs[index]?.name : undefined);
}
