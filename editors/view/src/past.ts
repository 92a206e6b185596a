// Past of a run that a page receives after the present, in parts, the latest first.

import { batch, type ReadonlySignal, signal } from "@preact/signals";
import { isPart, readPart } from "./part";
import type { RunLog } from "./runLog";

/** State of the page into which parts are inserted. */
export interface PresentState {
  /** Inserts successive parts before all messages, in small steps. Returns false if there is no room for all of them. */
  insert: (parts: readonly RunLog[]) => Generator<void, boolean>;
  /** Time that the user has chosen. */
  chosen: ReadonlySignal<number | undefined>;
  /** Oldest time with data. */
  oldest: ReadonlySignal<number>;
  /** Called when no more parts follow. */
  end: () => void;
}

/** Time for which parts are processed before the browser draws and handles input, in ms. */
const SLICE = 12;

/**
 * Parts are processed in slices, so that messages of the present and the user's input are processed between them. Inserting parts repeats
 * all messages, so that parts wait until they are as long as everything before, or until the user waits for their time.
 */
export class Past {
  /** Time from which messages will be there; `undefined` if no part follows. */
  readonly from = signal<number | undefined>(undefined);
  private blocks: Uint8Array[] = [];
  /** Parts that were read and not inserted, the latest first. */
  private parts: RunLog[] = [];
  /** Bytes of these parts, and of the inserted ones. */
  private size = 0;
  private inserted = 0;
  private isComplete = true;
  private isScheduled = false;
  /** Processing that is not finished. */
  private work: Generator<void> | undefined;

  constructor(private readonly present: PresentState) {}

  /** Processes a message about the times of the past. */
  announce({ from, to }: { from: number; to: number }): void {
    this.isComplete = from === to;
    if (this.from.peek() === undefined && this.isComplete) {
      return;
    }
    this.from.value = from;
    this.schedule();
  }

  /** Processes a binary message with a part. Returns false for other messages. */
  take(bytes: Uint8Array): boolean {
    if (!isPart(bytes)) {
      return false;
    }
    if (this.from.peek() !== undefined) {
      this.blocks.push(bytes);
      if (this.inserted === 0) {
        // Messages of the present follow.
        finish(this.process());
      } else {
        this.schedule();
      }
    }
    return true;
  }

  /** Ignores all further parts, for example because the connection is lost. */
  stop(): void {
    if (this.from.peek() !== undefined) {
      this.restart();
      this.present.end();
    }
  }

  /** Begins another run. */
  restart(): void {
    this.blocks = [];
    this.parts = [];
    [this.size, this.inserted, this.isComplete] = [0, 0, true];
    this.work = undefined;
    this.from.value = undefined;
  }

  private schedule(): void {
    if (!this.isScheduled) {
      this.isScheduled = true;
      setTimeout(() => {
        this.isScheduled = false;
        batch(() => this.continue());
      });
    }
  }

  /** Processes parts for one slice. */
  private continue(): void {
    if (this.from.peek() === undefined) {
      return;
    }
    const work = (this.work ??= this.process());
    const end = performance.now() + SLICE;
    // Another run may begin meanwhile.
    while (this.work === work && performance.now() < end) {
      if (work.next().done === true) {
        this.work = undefined;
        break;
      }
    }
    const hasMore = this.work !== undefined || this.blocks.length > 0 || this.isComplete;
    if (this.from.peek() !== undefined && hasMore) {
      this.schedule();
    }
  }

  private *process(): Generator<void> {
    for (let block = this.blocks.shift(); ; block = this.blocks.shift()) {
      if (block !== undefined) {
        this.parts.push(yield* readPart(block));
        this.size += block.length;
      }
      const isLast = this.isComplete && this.blocks.length === 0;
      if (isLast || this.size >= this.inserted || this.isAwaited()) {
        yield* this.insert();
      }
      if (isLast) {
        this.stop();
      }
      if (this.blocks.length === 0) {
        return;
      }
      yield;
    }
  }

  /** Whether the user has chosen a time in these parts. */
  private isAwaited(): boolean {
    const chosen = this.present.chosen.peek() ?? Infinity;
    return chosen < this.present.oldest.peek() && chosen >= (this.parts.at(-1)?.start ?? Infinity);
  }

  private *insert(): Generator<void> {
    const parts = this.parts.toReversed();
    this.parts = [];
    this.inserted += this.size;
    this.size = 0;
    if (parts.length > 0 && !(yield* this.present.insert(parts))) {
      this.stop();
    }
  }
}

function finish(work: Generator<void>): void {
  while (work.next().done !== true) {
    // Each step does a part of the work.
  }
}
