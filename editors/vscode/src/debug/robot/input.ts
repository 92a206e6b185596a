// The arguments of requests for the texts that a user types for the cell. Pure functions.

/** A key with a character is typed, because 1, 2 and 3 are also names of other keys. */
export function keyArgument(key: string): object {
  return key.length === 1 ? { key: key.charCodeAt(0) } : { key };
}

/** The value that a text means; nothing if it means none. */
export function levelFrom(text: string, isDigital: boolean): boolean | number | undefined {
  const written = text.trim().toLowerCase();
  if (isDigital) {
    return ["true", "1"].includes(written) ? true : ["false", "0"].includes(written) ? false : undefined;
  }
  const number = Number(written);
  return written === "" || !Number.isFinite(number) ? undefined : number;
}
