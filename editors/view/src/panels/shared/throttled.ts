// Signal with a limited rate of changes.

import { effect, type ReadonlySignal, signal } from "@preact/signals";

/** Follows `source`, but changes at most every `interval` milliseconds. The last value is always shown. */
export function throttled<Value>(source: ReadonlySignal<Value>, interval: number): ReadonlySignal<Value> {
  const slow = signal(source.peek());
  let timer: ReturnType<typeof setTimeout> | undefined;
  let isLate = false;
  const update = (): void => {
    slow.value = source.peek();
    isLate = false;
    timer = setTimeout(() => {
      timer = undefined;
      if (isLate) {
        update();
      }
    }, interval);
  };
  effect(() => {
    source.valueOf();
    if (timer === undefined) {
      update();
    } else {
      isLate = true;
    }
  });
  return slow;
}
