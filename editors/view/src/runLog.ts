// Messages and samples in their order: all of them, or a part.

import { MOST_MESSAGES, MOST_SAMPLES, since, upTo } from "./bounds";
import type { RunMessage } from "./protocol";
import { Samples } from "./samples";
import { shared } from "./sharing";
import type { MotionMessage } from "./wire";

export class RunLog {
  /** Complete state at the beginning; empty if the beginning is the start of the run. */
  state: RunMessage[] = [];
  messages: RunMessage[] = [];
  readonly samples = new Samples();
  /** Earliest time to which a debugger has gone back, in s. Earlier parts are valid up to this time. */
  private rewound = Infinity;
  private lastMotion: MotionMessage | undefined;

  /** `start` is the time of the beginning, in s. */
  constructor(public start = 0) {}

  /** Adds a message, or a message of the state at the beginning. Returns the stored message. */
  add(received: RunMessage, isState = false): RunMessage {
    const message: RunMessage = received.kind === "motion" ? { ...received, ...shared(received, this.lastMotion) } : received;
    if (message.kind === "motion") {
      this.lastMotion = message;
    }
    (isState ? this.state : this.messages).push(message);
    return message;
  }

  /** Discards everything. */
  clear(): void {
    this.state = [];
    this.messages = [];
    this.samples.clear();
    this.rewound = Infinity;
    this.start = 0;
  }

  /** Discards messages and samples after a time. */
  cut(t: number): void {
    this.rewound = Math.min(this.rewound, t);
    this.messages = upTo(this.messages, t);
    this.samples.cut(t);
    if (t < this.start) {
      this.state = [];
      this.start = t;
    }
  }

  /** Returns a time up to which messages must be discarded, because there are too many messages or samples. */
  surplus(): number | undefined {
    if (this.samples.count > MOST_SAMPLES) {
      return this.samples.middle();
    }
    if (this.messages.length > MOST_MESSAGES) {
      const middle = this.messages.slice(this.messages.length >> 1).find((kept) => "t" in kept);
      return middle !== undefined && "t" in middle ? middle.t : Infinity;
    }
    return undefined;
  }

  /** Replaces messages and samples before a time by the state at this time. */
  dropBefore(t: number): void {
    this.samples.drop(t);
    this.messages = since([...this.state, ...this.messages], t);
    this.state = [];
    this.start = t;
  }

  /** Inserts the parts before this one, in their order. Returns false if there is no room for all of them. */
  prepend(parts: readonly RunLog[]): boolean {
    const inserted: RunMessage[][] = [];
    let count = this.messages.length;
    for (const part of parts.toReversed()) {
      count += part.messages.length;
      if (count > MOST_MESSAGES || this.samples.count + part.samples.count > MOST_SAMPLES) {
        break;
      }
      part.cut(this.rewound);
      this.rewound = Math.min(this.rewound, part.rewound);
      this.samples.prepend(part.samples);
      this.state = part.state;
      this.start = part.start;
      inserted.unshift(part.messages);
    }
    this.messages = [...inserted.flat(), ...this.messages];
    return inserted.length === parts.length;
  }
}
