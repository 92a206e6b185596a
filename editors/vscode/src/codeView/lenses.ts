// Lenses of a program are above its name. A code view does not contain the name, so they are above its first line.

import type { Range } from "./mapping";
import type { Target } from "./requests";

export const LENSES = "textDocument/codeLens";
export const RESOLVE = "codeLens/resolve";

export interface Lens {
  range: Range;
  command?: { title: string; command: string; arguments?: unknown[] };
  data?: object;
}

/** Data of a lens in a view, from which the request about the lens of the file is made. */
interface Origin {
  code: string;
  range: Range;
}

const TOP: Range = { start: { line: 0, character: 0 }, end: { line: 0, character: 0 } };

/** The lenses of the file that are about the program of the view. */
export function lensesToCode(lenses: Lens[] | null, target: Target): Lens[] {
  const own = (lenses ?? []).filter(({ range }) => target.mapping.isHead(range.start));
  return own.map((lens) => {
    const origin: Origin = { code: target.code, range: lens.range };
    return { ...lens, range: TOP, data: lens.data && { ...lens.data, origin } };
  });
}

/** The lens of the file for a lens of a view; nothing for any other lens. */
export function lensOfFile(lens: Lens): Lens | undefined {
  const origin = originOf(lens);
  return origin && { ...lens, range: origin.range };
}

/** The server's response for the view, whose locations are listed at the view's first line. */
export async function lensToCode(resolved: Lens, asked: Lens, follow: (places: unknown) => Promise<unknown>): Promise<Lens> {
  const [, , places] = resolved.command?.arguments ?? [];
  const origin = originOf(asked);
  if (resolved.command === undefined || places === undefined || origin === undefined) {
    return { ...resolved, range: asked.range };
  }
  const command = { ...resolved.command, arguments: [origin.code, asked.range.start, await follow(places)] };
  return { ...resolved, range: asked.range, command };
}

function originOf({ data }: Lens): Origin | undefined {
  return (data as { origin?: Origin } | undefined)?.origin;
}
