// Code lenses in code views. In the file they are above the program's name, which a code view does not contain, so the
// view shows them above its first line.

import type { Range } from "./mapping";
import type { Target } from "./requests";

export const LENSES = "textDocument/codeLens";
export const RESOLVE = "codeLens/resolve";

export interface Lens {
  range: Range;
  command?: { title: string; command: string; arguments?: unknown[] };
  data?: object;
}

/** Data of a lens in a view, from which the request for the lens in the file is built. */
interface Origin {
  code: string;
  range: Range;
}

const TOP: Range = { start: { line: 0, character: 0 }, end: { line: 0, character: 0 } };

/** Returns the file's lenses for the program in the view. */
export function lensesToCode(lenses: Lens[] | null, target: Target): Lens[] {
  const own = (lenses ?? []).filter(({ range }) => target.mapping.isHead(range.start));
  return own.map((lens) => {
    const origin: Origin = { code: target.code, range: lens.range };
    return { ...lens, range: TOP, data: lens.data && { ...lens.data, origin } };
  });
}

/** Returns the file's lens for a lens in a view; `undefined` for any other lens. */
export function lensOfFile(lens: Lens): Lens | undefined {
  const origin = originOf(lens);
  return origin && { ...lens, range: origin.range };
}

/** Converts the server's response for the view. Its locations are listed at the first line of the view. */
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
