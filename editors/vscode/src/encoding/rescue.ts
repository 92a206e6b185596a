// Texts of files as they must be saved, so that no character is lost. Knows text alone.

import type { Replacement } from "../codeView/projection";

/** Stands for each byte sequence that could not be read. */
export const LOST = "\ufffd";
const CDATA = /<!\[CDATA\[[^]*?(?:\]\]>|$)/g;

/**
 * A text that was read in the wrong encoding and then edited, with its lost characters again. `read` is the text as it
 * was read, `right` the text of the same bytes in the right encoding. Nothing where it is no longer clear which
 * character was which.
 */
export function restore(edited: string, read: string, right: string): string | undefined {
  const lost = lostCharacters(read, right);
  if (lost === undefined || edited.split(LOST).length !== read.split(LOST).length) {
    return undefined;
  }
  let next = 0;
  return edited.replaceAll(LOST, () => lost[next++] ?? LOST);
}

/** What stands in `right` for each lost character of `read`: the texts between them are the same. */
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
 * The edits that write as references what an encoding does not have. `has` says whether it has a character. Nothing where
 * such a character is in a CDATA section, in which there are no references.
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

/** The edit that makes the XML declaration say UTF-8. */
export function asUtf8(text: string): Replacement[] {
  const [, before, name] = /^(<\?xml[^>]*?\sencoding\s*=\s*["'])([^"']*)/i.exec(text) ?? [];
  const isChanged = before !== undefined && name !== undefined && name.toLowerCase() !== "utf-8";
  return !isChanged ? [] : [{ start: before.length, end: before.length + name.length, text: "utf-8" }];
}
