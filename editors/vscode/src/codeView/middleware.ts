// Redirects messages about code views to their files. See requests.ts.

import * as vscode from "vscode";
import type { Middleware } from "vscode-languageclient/node";
import type { CodeFiles } from "./files";
import { FOLLOWED, inCodeViews } from "./follow";
import { type Lens, lensOfFile, lensToCode, RESOLVE } from "./lenses";
import type { Link } from "./link";
import { type Target, toCode, toFile } from "./requests";
import { SCHEME } from "./uris";

const DELTA = "textDocument/semanticTokens/full/delta";
const FULL = "textDocument/semanticTokens/full";

interface AboutDocument {
  textDocument?: { uri?: string };
  /** Set for a call or type hierarchy. */
  item?: { uri?: string };
}

export function codeViewMiddleware(views: CodeFiles): Middleware {
  return {
    async sendRequest(type, params, token, next) {
      const method = typeof type === "string" ? type : type.method;
      const lens = method === RESOLVE ? lensOfFile(params as Lens) : undefined;
      if (lens !== undefined) {
        const resolved = (await next(type, lens as typeof params, token)) as Lens;
        return (await lensToCode(resolved, params as Lens, inCodeViews)) as never;
      }
      const code = viewOf(params);
      const link = code && views.find(code);
      if (link === undefined) {
        return code === undefined ? next(type, params, token) : (null as never);
      }
      await link.settled();
      const target = targetOf(link);
      if (target === undefined) {
        return null as never;
      }
      // The server's previous tokens are those of the entire file, so differences from them cannot be converted.
      const asked = method === DELTA ? FULL : type;
      const answer: unknown = await next(asked, toFile(params, target) as typeof params, token);
      const mapped = toCode(method, answer, target);
      return (FOLLOWED.has(method) ? await inCodeViews(mapped) : mapped) as never;
    },
    async sendNotification(type, next, params) {
      // The server needs no notification about the view, because its file is updated.
      if (viewOf(params) === undefined) {
        await next(type, params);
      }
    },
  };
}

/** Returns the code view to which a message refers. */
function viewOf(params: unknown): vscode.Uri | undefined {
  const about = params as AboutDocument | null | undefined;
  const uri = about?.textDocument?.uri ?? about?.item?.uri;
  return uri?.startsWith(`${SCHEME}:`) === true ? vscode.Uri.parse(uri) : undefined;
}

function targetOf(link: Link): Target | undefined {
  const mapping = link.mapping();
  return mapping && { code: link.code.toString(), file: link.file.uri.toString(), mapping };
}
