// Converts semantic tokens of a file to tokens of the code in it.

import type { Mapping } from "./mapping";

/** Numbers per token: line and start relative to the previous token, length, type, modifiers. */
const WIDTH = 5;

export function toCodeTokens(answer: unknown, mapping: Mapping): unknown {
  const data = (answer as { data?: number[] } | null)?.data;
  if (data === undefined) {
    return null;
  }
  const tokens: number[] = [];
  let file = { line: 0, character: 0 };
  let last = { line: 0, character: 0 };
  for (let at = 0; at + WIDTH <= data.length; at += WIDTH) {
    const [lines = 0, characters = 0, length = 0, type = 0, modifiers = 0] = data.slice(at, at + WIDTH);
    file = { line: file.line + lines, character: lines === 0 ? file.character + characters : characters };
    const start = mapping.toCode(file);
    const end = mapping.toCode({ line: file.line, character: file.character + length });
    if (start === undefined || end === undefined || end.character <= start.character) {
      continue;
    }
    const line = start.line - last.line;
    tokens.push(line, line === 0 ? start.character - last.character : start.character, end.character - start.character, type, modifiers);
    last = start;
  }
  return { data: tokens };
}
