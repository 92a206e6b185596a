// Variables in the code, by the semantic tokens of the language server. Pure functions.

/** Semantic tokens with a value. */
const VALUES = new Set(["variable", "parameter"]);
const NAMESPACE = "namespace";
/** Numbers of a semantic token: line and start from the token before, length, type, modifiers. */
const WIDTH = 5;

export interface Expression {
  line: number;
  start: number;
  end: number;
  text: string;
}

/** The variables on some lines, each where it occurs last; those of libraries with the name of the library. */
export function expressions(
  data: ArrayLike<number>,
  types: string[],
  lines: { first: number; last: number },
  textOf: (line: number, start: number, end: number) => string,
): Expression[] {
  const found = new Map<string, Expression>();
  let [line, start] = [0, 0];
  let library: Expression | undefined;
  for (let at = 0; at + WIDTH <= data.length; at += WIDTH) {
    const [lineDelta = 0, startDelta = 0, length = 0, type = 0] = Array.from({ length: WIDTH }, (_, index) => data[at + index]);
    start = lineDelta === 0 ? start + startDelta : startDelta;
    line += lineDelta;
    if (line < lines.first || line > lines.last) {
      continue;
    }
    const end = start + length;
    const name = types[type] ?? "";
    if (name === NAMESPACE) {
      library = { line, start, end, text: textOf(line, start, end) };
    } else if (VALUES.has(name)) {
      const isOfLibrary = library?.line === line && textOf(line, library.end, start) === ":";
      const from = isOfLibrary && library !== undefined ? library.start : start;
      const text = textOf(line, from, end);
      found.set(text, { line, start: from, end, text });
    }
  }
  return [...found.values()];
}

/** The first line of the code of the program that line `last` is in. A code view has no XML before its code. */
export function firstLineOfCode(lineAt: (line: number) => string, last: number): number {
  for (let line = last; line > 0; line -= 1) {
    if (/<code[\s>]/i.test(lineAt(line))) {
      return line;
    }
  }
  return 0;
}
