// Choices of the user that survive a reload of the page.

/** Returns a stored value; `undefined` without a stored value, or if the page may store nothing. */
export function remembered(key: string): string | undefined {
  try {
    return localStorage.getItem(`val3.${key}`) ?? undefined;
  } catch {
    return undefined;
  }
}

/** Stores a value, if the page may store something. */
export function remember(key: string, value: string): void {
  try {
    localStorage.setItem(`val3.${key}`, value);
  } catch {
    // The choice is valid until the next reload.
  }
}
