// Plays the history: the shown time advances with the user's clock.

import { effect, signal } from "@preact/signals";
import type { Store } from "../store";

/** Seconds in which the highest speed plays the entire history. */
const SHORTEST = 2;

export class Player {
  readonly isPlaying = signal(false);
  readonly speed = signal<number | "max">(1);
  private last: number | undefined;

  constructor(private readonly store: Store) {}

  play(): void {
    const { chosen, newest, oldest } = this.store;
    if ((chosen.peek() ?? newest.peek()) >= newest.peek()) {
      chosen.value = oldest.peek();
    }
    this.isPlaying.value = true;
    this.last = undefined;
    requestAnimationFrame(this.advance);
  }

  /** Plays as soon as the history is complete. */
  playWhenRead(): void {
    const stop = effect(() => {
      if (this.store.chosen.value !== undefined) {
        queueMicrotask(() => stop());
        this.play();
      }
    });
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
    const speed = this.speed.peek();
    const factor = speed === "max" ? newest.peek() / SHORTEST : speed;
    const next = t + ((now - (this.last ?? now)) / 1000) * factor;
    this.last = now;
    chosen.value = Math.min(next, newest.peek());
    if (next >= newest.peek()) {
      this.isPlaying.value = false;
    } else {
      requestAnimationFrame(this.advance);
    }
  };
}
