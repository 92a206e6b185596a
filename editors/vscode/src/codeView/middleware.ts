// Leads the messages about code views to their files. See requests.ts.

import * as vscode from "vscode";
import type { LanguageClient, Middleware } from "vscode-languageclient/node";
import type { CodeFiles } from "./files";
import type { Link } from "./link";
import { type Target, toCode, toFile } from "./requests";
import { SCHEME } from "./uris";

const DELTA = "textDocument/semanticTokens/full/delta";
const FULL = "textDocument/semanticTokens/full";

interface AboutDocument {
  textDocument?: { uri?: string };
}

export function codeViewMiddleware(views: CodeFiles): Middleware {
  return {
    async sendRequest(type, params, token, next) {
      const link = linkOf(params, views);
      if (link === undefined) {
        return next(type, params, token);
      }
      await link.settled();
      const method = typeof type === "string" ? type : type.method;
      const target = targetOf(link);
      if (target === undefined || !isAboutView(params)) {
        return null as never;
      }
      // The server's previous tokens are those of the whole file, so that a difference to them says nothing here.
      const asked = method === DELTA ? FULL : type;
      const answer: unknown = await next(asked as typeof type, toFile(params, target) as typeof params, token);
      return toCode(method, answer, target) as never;
    },
    async sendNotification(type, next, params) {
      // The server knows the file, which follows the view.
      if (!isAboutView(params)) {
        await next(type, params);
      }
    },
    handleDiagnostics(uri, diagnostics, next) {
      next(uri, diagnostics);
      const link = uri.scheme === SCHEME ? undefined : views.find(uri);
      if (link !== undefined) {
        next(link.code, inView(link, diagnostics));
      }
    },
  };
}

/** A view that is opened shows at once what is known about its file, and nothing after it was closed. */
export function showFindings(client: LanguageClient, views: CodeFiles, context: vscode.ExtensionContext): void {
  context.subscriptions.push(
    vscode.workspace.onDidOpenTextDocument((document) => {
      const link = document.uri.scheme === SCHEME ? views.find(document.uri) : undefined;
      if (link !== undefined) {
        client.diagnostics?.set(link.code, inView(link, client.diagnostics.get(link.file.uri) ?? []));
      }
    }),
    vscode.workspace.onDidCloseTextDocument((document) => {
      if (document.uri.scheme === SCHEME) {
        client.diagnostics?.delete(document.uri);
      }
    }),
  );
}

function isAboutView(params: unknown): boolean {
  return (params as AboutDocument | undefined)?.textDocument?.uri?.startsWith(`${SCHEME}:`) === true;
}

function linkOf(params: unknown, views: CodeFiles): Link | undefined {
  return isAboutView(params) ? views.find((params as { textDocument: { uri: string } }).textDocument.uri) : undefined;
}

function targetOf(link: Link): Target | undefined {
  const mapping = link.mapping();
  return mapping && { code: link.code.toString(), file: link.file.uri.toString(), mapping };
}

function inView(link: Link, diagnostics: readonly vscode.Diagnostic[]): vscode.Diagnostic[] {
  const mapping = link.mapping();
  return diagnostics.flatMap((diagnostic) => {
    const range = mapping?.rangeToCode(diagnostic.range);
    if (range === undefined) {
      return [];
    }
    const { start, end } = range;
    const place = new vscode.Range(start.line, start.character, end.line, end.character);
    return [Object.assign(new vscode.Diagnostic(place, diagnostic.message, diagnostic.severity), {
      code: diagnostic.code,
      source: diagnostic.source,
      tags: diagnostic.tags,
      relatedInformation: diagnostic.relatedInformation,
    })];
  });
}
