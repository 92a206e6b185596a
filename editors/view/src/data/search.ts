// Search for data and elements that match words.

import type { Access, Datum, Value } from "./protocol";

export interface Filter {
  text: string;
  access: Access | "all";
  /** Whether to show only data with findings. */
  isFaultyOnly: boolean;
}

/** Texts by datum in lower case, cached as long as the tables exist. */
const texts = new WeakMap<Datum, string>();

export function wordsOf(text: string): string[] {
  return text.toLowerCase().split(/\s+/).filter((word) => word !== "");
}

/** Whether a datum passes the filter: each word must be in the name, a key or a value. */
export function matches(datum: Datum, { text, access, isFaultyOnly }: Filter, isFaulty: (name: string) => boolean): boolean {
  const words = wordsOf(text);
  return (access === "all" || datum.access === access) && (!isFaultyOnly || isFaulty(datum.name))
    && (words.length === 0 || hasWords(textOf(datum), words));
}

/** Returns the elements that match a search: all of them if the datum's name already matches. */
export function matchingKeys(datum: Datum, text: string, keys: readonly string[]): readonly string[] {
  const words = wordsOf(text);
  if (words.length === 0 || hasWords(datum.name.toLowerCase(), words)) {
    return keys;
  }
  const name = datum.name.toLowerCase();
  const values = new Map(datum.values.map((value) => [value.key, value]));
  const found = keys.filter((key) => {
    const value = values.get(key);
    return value !== undefined && hasWords(`${name}\n${valueText(value)}`, words);
  });
  return found.length === 0 ? keys : found;
}

function hasWords(text: string, words: readonly string[]): boolean {
  return words.every((word) => text.includes(word));
}

function textOf(datum: Datum): string {
  const known = texts.get(datum);
  if (known !== undefined) {
    return known;
  }
  const text = [datum.name.toLowerCase(), ...datum.values.map(valueText)].join("\n");
  texts.set(datum, text);
  return text;
}

function valueText({ key, texts, fields = [] }: Value): string {
  return [key.toLowerCase(), ...texts.map((text) => (text ?? "").toLowerCase()), ...fields.map(textOf)].join("\n");
}
