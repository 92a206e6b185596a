// Size of a local: `3`, or `3 x 4` for two dimensions.

export function shownSize(size: readonly number[]): string {
  return size.join(" x ");
}

/** Parses a size; `undefined` if it is not a size. */
export function readSize(text: string): number[] | undefined {
  const parts = text.trim().split(/\s*[x,*;\s]\s*/i);
  const numbers = parts.map((part) => (/^\d{1,9}$/.test(part) ? Number(part) : NaN));
  const isSize = numbers.length <= 3 && numbers.every((number) => number >= 1);
  return isSize ? numbers : undefined;
}
