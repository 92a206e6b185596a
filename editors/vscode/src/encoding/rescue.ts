// Computes the text with which a file must be saved so that no character is lost. Pure functions.

import type { Replacement } from "../codeView/projection";

/** Replacement character for byte sequences that could not be decoded. */
export const LOST = "\ufffd";
const CDATA = /<!\[CDATA\[[^]*?(?:\]\]>|$)/g;

/**
 * Restores the lost characters of a text that was read in the wrong encoding and then edited. `read` is the text before
 * the edits, `right` the text of the same bytes in the right encoding. Returns `undefined` if the characters can no
 * longer be identified.
 */
export function restore(edited: string, read: string, right: string): string | undefined {
  const lost = lostCharacters(read, right);
  if (lost === undefined || edited.split(LOST).length !== read.split(LOST).length) {
    return undefined;
  }
  let next = 0;
  return edited.replaceAll(LOST, () => lost[next++] ?? LOST);
}

/** Returns the characters of `right` at each lost character of `read`. The texts between them are equal. */
function lostCharacters(read: string, right: string): string[] | undefined {
  const [first = "", ...between] = read.split(LOST);
  if (!right.startsWith(first)) {
    return undefined;
  }
  const lost: string[] = [];
  let at = first.length;
  for (const [index, text] of between.entries()) {
    const isLast = index === between.length - 1;
    const end = isLast ? right.length - text.length : right.indexOf(text, at + 1);
    if (end <= at || !right.startsWith(text, end)) {
      return undefined;
    }
    lost.push(right.slice(at, end));
    at = end + text.length;
  }
  return lost;
}

/**
 * Returns the edits that replace characters missing in an encoding by references; `has` returns whether the encoding
 * contains a character. `undefined` if such a character is in a CDATA section, where references are not possible.
 */
export function asReferences(text: string, has: (character: string) => boolean): Replacement[] | undefined {
  const sections = Array.from(text.matchAll(CDATA), ({ 0: section, index }) => ({ start: index, end: index + section.length }));
  const letters = Array.from(text.matchAll(/[^\0-\x7f]/gu), ({ 0: character, index }) => ({ character, index }));
  const missing = letters.filter(({ character }) => !has(character));
  const isInSection = ({ index }: { index: number }): boolean => sections.some(({ start, end }) => start < index && index < end);
  return missing.some(isInSection) ? undefined : missing.map(({ character, index }) => {
    return { start: index, end: index + character.length, text: `&#${character.codePointAt(0)};` };
  });
}

/** Returns the edit that sets UTF-8 in the XML declaration. */
export function asUtf8(text: string): Replacement[] {
  const [, before, name] = /^(<\?xml[^>]*?\sencoding\s*=\s*["'])([^"']*)/i.exec(text) ?? [];
  const isChanged = before !== undefined && name !== undefined && name.toLowerCase() !== "utf-8";
  return !isChanged ? [] : [{ start: before.length, end: before.length + name.length, text: "utf-8" }];
}
