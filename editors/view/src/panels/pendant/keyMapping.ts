// Maps keys of the PC keyboard to keys of the pendant.

/** Codes of pendant keys that write no character (manual 12.2). */
export const CODES = {
  Esc: 255, Tab: 259, UnTab: 260, Up: 261, PgUp: 262, Bksp: 263, Left: 264, Home: 265, Down: 266, PgDn: 267,
  Right: 268, End: 269, Return: 270, F1: 271, F2: 272, F3: 273, F4: 274, F5: 275, F6: 276, F7: 277, F8: 278,
} as const;

/** Keys 1, 2 and 3 at the left edge of the pendant, which programs can read at any time. */
export const USER_KEYS = [281, 282, 283] as const;

export type PageStep = "next" | "previous" | "first" | "last";

/** Key of the pendant, or a change of the displayed user page. */
export type PendantKey = { code: number } | { page: PageStep };

/** Properties of a keyboard event that determine the key. */
export interface TypedKey {
  key: string;
  code: string;
  altKey: boolean;
  ctrlKey: boolean;
  metaKey: boolean;
  shiftKey: boolean;
  /** Whether AltGr is pressed, which browsers also report as Ctrl and Alt. */
  isAltGraph: boolean;
  isComposing: boolean;
}

/** Keys by name. Tab moves the focus, so Insert replaces it. */
const NAMED: Partial<Record<string, number>> = {
  Escape: CODES.Esc, Enter: CODES.Return, Backspace: CODES.Bksp, Delete: CODES.Bksp,
  ArrowUp: CODES.Up, ArrowDown: CODES.Down, ArrowLeft: CODES.Left, ArrowRight: CODES.Right,
  PageUp: CODES.PgUp, PageDown: CODES.PgDn, Home: CODES.Home, End: CODES.End,
  F1: CODES.F1, F2: CODES.F2, F3: CODES.F3, F4: CODES.F4, F5: CODES.F5, F6: CODES.F6, F7: CODES.F7, F8: CODES.F8,
};

/** Mapping as the panel's help shows it. */
export const KEYBOARD_HELP: readonly (readonly [keys: string, meaning: string])[] = [
  ["Letters, digits, signs, Enter, Esc, arrows, Home, End, PgUp, PgDn, F1 to F8", "the same key of the pendant"],
  ["Backspace, Delete", "Bksp"],
  ["Insert, Shift+Insert", "Tab, UnTab of the pendant; Tab itself moves the focus"],
  ["Alt+1, Alt+2, Alt+3", "the keys 1, 2 and 3 at the edge of the pendant"],
  ["F9, F10", "the previous and the next user page; with Shift the first and the last"],
];

/** Returns the pendant key for a key of the keyboard; `undefined` if the browser should handle the key. */
export function pendantKey(typed: TypedKey): PendantKey | undefined {
  const { key, altKey, ctrlKey, metaKey, shiftKey, isAltGraph, isComposing } = typed;
  if (isComposing || metaKey) {
    return undefined;
  }
  if ((ctrlKey || altKey) && !isAltGraph) {
    return altKey && !ctrlKey ? userKey(typed) : undefined;
  }
  if (key === "Insert") {
    return { code: shiftKey ? CODES.UnTab : CODES.Tab };
  }
  if (key === "F9" || key === "F10") {
    return { page: key === "F9" ? (shiftKey ? "first" : "previous") : (shiftKey ? "last" : "next") };
  }
  const code = NAMED[key] ?? characterCode(key);
  return code === undefined ? undefined : { code };
}

/** Returns the key for Alt with a digit. On some keyboards Alt changes the character, so the physical key is used. */
function userKey({ code }: TypedKey): PendantKey | undefined {
  const digit = /^(?:Digit|Numpad)([123])$/.exec(code)?.[1];
  const found = USER_KEYS[Number(digit) - 1];
  return found === undefined ? undefined : { code: found };
}

/**
 * Returns the code of the key that writes a character; `undefined` for codes of other keys and of control characters.
 */
export function characterCode(text: string): number | undefined {
  const [character, ...more] = text;
  const code = character?.codePointAt(0);
  if (code === undefined || more.length > 0 || code > 0xffff) {
    return undefined;
  }
  const isWritten = (code >= 32 && code <= 126) || (code >= 160 && !(code >= 255 && code <= 283));
  return isWritten ? code : undefined;
}
