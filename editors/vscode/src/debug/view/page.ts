// Page that shows the robot, as a document for a webview.

import { createHash } from "node:crypto";

/** Adds a policy: the page may execute only its own scripts, and must not load anything. */
export function withPolicy(page: string): string {
  const hashes = (tag: string): string => [...page.matchAll(new RegExp(`<${tag}(?: [^>]*)?>([^]*?)</${tag}>`, "g"))]
    .map(([, content]) => `'sha256-${createHash("sha256").update(content ?? "").digest("base64")}'`)
    .join(" ");
  // Elements are positioned by style attributes.
  const policy = `default-src 'none'; script-src ${hashes("script")}; style-src 'unsafe-inline'; img-src data: blob:; font-src data:`;
  return page.replace("<head>", `<head><meta http-equiv="Content-Security-Policy" content="${policy}">`);
}
