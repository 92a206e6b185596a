// Outline of a code view: the program with its parameters and locals, although these are declared in the XML.

import type { Range } from "./mapping";
import type { Target } from "./requests";

export const SYMBOLS = "textDocument/documentSymbol";
/** `SymbolKind.Function` of the protocol. */
const FUNCTION = 12;
/** Comments, strings, and names. */
const WORD = /\/\/.*|"[^"\r\n]*"?|([A-Za-z_]\w*)/g;

export interface Symbol {
  name: string;
  detail?: string;
  kind: number;
  range: Range;
  selectionRange: Range;
  children?: Symbol[];
}

/** Returns the symbol of the view's program. Parameters and locals are located at their first use. */
export function symbolsToCode(symbols: Symbol[] | null, { mapping }: Target): Symbol[] {
  const { code, program } = mapping.projection;
  const range = mapping.wholeCode();
  const head = { start: range.start, end: mapping.inCode("begin".length) };
  const found = symbols?.find((symbol) => mapping.rangeToCode(symbol.range) !== undefined);
  const uses = firstUses(code);
  const children = (found?.children ?? []).map((child): Symbol => {
    const at = uses.get(child.name);
    const place = at === undefined ? head : { start: mapping.inCode(at), end: mapping.inCode(at + child.name.length) };
    return { ...child, range: place, selectionRange: place };
  });
  return [{ name: program || "(no name)", kind: FUNCTION, ...found, range, selectionRange: head, children }];
}

/** Returns for each name the offset of the first occurrence in the code. */
function firstUses(code: string): Map<string, number> {
  const uses = new Map<string, number>();
  for (const { 1: name, index } of code.matchAll(WORD)) {
    if (name !== undefined && !uses.has(name)) {
      uses.set(name, index);
    }
  }
  return uses;
}
