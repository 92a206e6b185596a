// User page as spans with the same text mode.

export const COLUMNS = 40;
export const ROWS = 14;

/** Number of consecutive columns with the same text mode (`setTextMode`). */
export type ModeRun = readonly [columns: number, mode: number];

export interface Span {
  text: string;
  isInverse: boolean;
  isFlashing: boolean;
}

/** Characters with the East Asian width "wide" occupy two columns, combining marks none. */
const WIDE = /[\u1100-\u115f\u2e80-\u303e\u3041-\ua4cf\ua960-\ua97c\uac00-\ud7a3\uf900-\ufaff\ufe30-\ufe6f\uff00-\uff60\uffe0-\uffe6]|[\u{1f300}-\u{1faff}\u{20000}-\u{3fffd}]/u;
const COMBINING = /\p{Mn}|\p{Me}|[\u200b-\u200f]/u;

export function columnsOf(character: string): number {
  return COMBINING.test(character) ? 0 : WIDE.test(character) ? 2 : 1;
}

/** Returns a line of the page, filled with spaces to 40 columns and divided where the text mode changes. */
export function spansOf(line: string, runs: readonly ModeRun[] = []): Span[] {
  const modes = runs.flatMap(([columns, mode]) => Array<number>(Math.max(0, Math.min(columns, COLUMNS))).fill(mode));
  const spans: (Span & { mode: number })[] = [];
  let column = 0;
  for (const character of filled(line)) {
    const width = columnsOf(character);
    const last = spans.at(-1);
    const mode = width === 0 ? (last?.mode ?? 0) : (modes[column] ?? 0);
    if (last !== undefined && last.mode === mode) {
      last.text += character;
    } else {
      spans.push({ text: character, mode, isInverse: mode === 1 || mode === 3, isFlashing: mode >= 2 });
    }
    column += width;
  }
  return spans.map(({ text, isInverse, isFlashing }) => ({ text, isInverse, isFlashing }));
}

/** Returns the texts above the keys F1 to F8: 5 columns each of the last line, where programs write menus. */
export function menuTexts(lastLine: string): string[] {
  const texts = Array.from({ length: 8 }, () => "");
  let column = 0;
  for (const character of lastLine) {
    const at = Math.min(Math.floor(column / 5), 7);
    texts[at] = (texts[at] ?? "") + character;
    column += columnsOf(character);
  }
  return texts.map((text) => text.trim());
}

function filled(line: string): string[] {
  const characters = Array.from(line);
  const columns = characters.reduce((sum, character) => sum + columnsOf(character), 0);
  return [...characters, ...Array<string>(Math.max(0, COLUMNS - columns)).fill(" ")];
}
