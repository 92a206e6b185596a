// Parts of chronological lists.

/** Returns the number of entries up to a time. */
export function countUpTo(entries: readonly { t: number }[], t: number): number {
  let [low, high] = [0, entries.length];
  while (low < high) {
    const middle = (low + high) >> 1;
    if ((entries[middle]?.t ?? Infinity) <= t) {
      low = middle + 1;
    } else {
      high = middle;
    }
  }
  return low;
}
