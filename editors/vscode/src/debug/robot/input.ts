// Converts text that a user types for the cell to request arguments. Pure functions.

/**
 * Returns the argument for a key. A key with a character is sent as the character, because 1, 2 and 3 are also names of
 * other keys.
 */
export function keyArgument(key: string): object {
  return key.length === 1 ? { key: key.charCodeAt(0) } : { key };
}

/** Converts a text to a value; `undefined` if it is not a value. */
export function levelFrom(text: string, isDigital: boolean): boolean | number | undefined {
  const written = text.trim().toLowerCase();
  if (isDigital) {
    return ["true", "1"].includes(written) ? true : ["false", "0"].includes(written) ? false : undefined;
  }
  const number = Number(written);
  return written === "" || !Number.isFinite(number) ? undefined : number;
}
