// Plays what has happened: the shown time advances with the clock of the reader.

import { signal } from "@preact/signals";
import type { Store } from "../store";

export class Player {
  readonly isPlaying = signal(false);
  readonly speed = signal(1);
  private last: number | undefined;

  constructor(private readonly store: Store) {}

  play(): void {
    const { chosen, newest } = this.store;
    if ((chosen.peek() ?? newest.peek()) >= newest.peek()) {
      chosen.value = 0;
    }
    this.isPlaying.value = true;
    this.last = undefined;
    requestAnimationFrame(this.advance);
  }

  pause(): void {
    this.isPlaying.value = false;
  }

  private readonly advance = (now: number): void => {
    const { chosen, newest } = this.store;
    const t = chosen.peek();
    if (!this.isPlaying.peek() || t === undefined) {
      this.isPlaying.value = false;
      return;
    }
    const next = t + ((now - (this.last ?? now)) / 1000) * this.speed.peek();
    this.last = now;
    chosen.value = Math.min(next, newest.peek());
    if (next >= newest.peek()) {
      this.isPlaying.value = false;
    } else {
      requestAnimationFrame(this.advance);
    }
  };
}
