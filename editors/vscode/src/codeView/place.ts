// Finds the code view that shows a position of a program file. Pure functions of texts.

import { Mapping, type Range } from "./mapping";
import { programsOf } from "./projection";

export interface Place {
  index: number;
  range: Range;
}

/** The position in a code view for one in the file: in the code, or at its beginning for the head of the program. */
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
