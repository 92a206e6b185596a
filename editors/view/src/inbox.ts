// Queue of received messages, which are processed together so that the page is updated only once.

import { batch } from "@preact/signals";
import { type Message, messageFrom } from "./protocol";
import type { Store } from "./store";

/**
 * Milliseconds for which a message waits for further ones. Without this delay, ten minutes of motion needed more than
 * two minutes to load.
 */
const DELAY = 15;

export class Inbox {
  private waiting: (string | ArrayBuffer | Uint8Array | Message)[] = [];
  private isScheduled = false;

  constructor(private readonly store: Store) {}

  add(message: string | ArrayBuffer | Uint8Array | Message): void {
    this.waiting.push(message);
    if (!this.isScheduled) {
      this.isScheduled = true;
      setTimeout(() => this.empty(), DELAY);
    }
  }

  /** Processes all queued messages. */
  empty(): void {
    const { waiting, store } = this;
    this.waiting = [];
    this.isScheduled = false;
    batch(() => {
      for (const message of waiting) {
        if (message instanceof ArrayBuffer || message instanceof Uint8Array) {
          store.takeBytes(message instanceof ArrayBuffer ? new Uint8Array(message) : message);
        } else {
          const read = typeof message === "string" ? messageFrom(message) : message;
          if (read !== undefined) {
            store.take(read);
          }
        }
      }
    });
  }
}
