// Numbers with a fixed number of decimals.

/** Returns a number with these decimals, and zero without a sign. */
export function fixed(value: number, digits: number): string {
  return value.toFixed(digits).replace(/^-(0\.?0*)$/, "$1");
}
