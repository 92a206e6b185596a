// Finds the code view that shows a position of a program file. Pure functions.

import { Mapping, type Range } from "./mapping";
import { programsOf } from "./projection";

export interface Place {
  index: number;
  range: Range;
}

/**
 * Converts a position in the file to a position in a code view: in the code, or at its beginning for the program's
 * head.
 */
export function placeInCode(text: string, range: Range): Place | undefined {
  for (const [index, { tagStart, tagEnd }] of programsOf(text).entries()) {
    const mapping = Mapping.of(text, index);
    const inside = mapping?.rangeToCode(range);
    if (inside !== undefined) {
      return { index, range: inside };
    }
    const at = mapping?.offsetInFile(range.start) ?? -1;
    if (tagStart <= at && at < tagEnd) {
      const start = { line: 0, character: 0 };
      return { index, range: { start, end: start } };
    }
  }
  return undefined;
}
