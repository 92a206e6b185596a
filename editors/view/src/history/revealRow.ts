/** Scrolls by the smallest distance until a row is visible below the heading, which has the same height. */
export function revealRow(box: HTMLElement, row: number, height: number): void {
  const top = row * height;
  if (top < box.scrollTop) {
    box.scrollTop = top;
  } else if (top + 2 * height > box.scrollTop + box.clientHeight) {
    box.scrollTop = top + 2 * height - box.clientHeight;
  }
}
