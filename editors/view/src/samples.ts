// Samples of the arm, in chronological order.

import { columnsOf, firstTime, headOf, type SampleColumns, timesOf } from "./sampleBatch";

export interface Sample {
  t: number;
  joints: readonly number[];
  speed: number;
  phase: number;
  tool: number;
  source: number | undefined;
  /** Speed limit, an index into `limits` of the scene. */
  limit: number;
}

/** Time span in which the arm is at rest. The last one has no end yet. */
export interface Rest {
  start: number;
  end: number;
  /** Speed limit that holds the arm, an index into `limits` of the scene. */
  limit: number;
}

/** Shortest time without samples that is a rest: more than a few cycles, in s. */
const SHORTEST_REST = 0.02;

/**
 * Batches of samples as received: an hour of motion has about 10 MB. A batch is decoded when it is read, and the last
 * decoded one is kept.
 */
export class Samples {
  private readonly batches: Batch[] = [];
  private decoded: { batch: Batch; columns: SampleColumns } | undefined;
  count = 0;
  /** Changes when samples are discarded, so that results computed from them are computed again. */
  epoch = 0;

  /**
   * Adds a batch, and returns its last time. Messages without samples are ignored. `isState` marks the batch of a complete
   * state, which stands for all earlier samples.
   */
  add(message: ArrayBuffer | Uint8Array, isState = false): number | undefined {
    const batch = Batch.from(message instanceof ArrayBuffer ? new Uint8Array(message) : message);
    if (batch === undefined || batch.count === 0) {
      return undefined;
    }
    batch.isState = isState;
    this.batches.push(batch);
    this.count += batch.count;
    return batch.end;
  }

  /** Inserts earlier samples, which replace the batch of a complete state. */
  prepend(earlier: Samples): void {
    const replaced = this.batches[0]?.isState === true ? 1 : 0;
    this.batches.splice(0, replaced, ...earlier.batches);
    this.recount();
  }

  clear(): void {
    this.batches.length = 0;
    this.decoded = undefined;
    this.count = 0;
    this.epoch += 1;
  }

  /** Discards the samples after a time. */
  cut(t: number): void {
    while ((this.batches.at(-1)?.start ?? -Infinity) > t) {
      this.batches.pop();
    }
    this.batches.at(-1)?.cut(t);
    this.recount();
  }

  /** Returns the time of the last sample; 0 without samples. */
  end(): number {
    return this.batches.at(-1)?.end ?? 0;
  }

  /** Returns the time in the middle of the samples. */
  middle(): number {
    return this.batches[this.batches.length >> 1]?.start ?? 0;
  }

  /** Discards the batches before the batch that is valid at a time. */
  drop(t: number): void {
    const first = this.batches.findIndex((_, index) => (this.batches[index + 1]?.start ?? Infinity) > t);
    this.batches.splice(0, first);
    this.recount();
  }

  /** Returns the sample at a time: the last one up to it, otherwise the first one. */
  at(t: number): Sample | undefined {
    const batch = this.batches[this.batchAt(t)];
    if (batch === undefined) {
      return undefined;
    }
    const { times } = this.columns(batch);
    return this.sample(batch, Math.max(0, upTo(batch.count, (index) => times[index] ?? Infinity, t) - 1));
  }

  /** Returns the rests of the arm, for which no samples are sent. */
  *rests(): Generator<Rest> {
    for (const [index, batch] of this.batches.entries()) {
      yield* this.restsIn(batch);
      const [start, end] = [batch.end, this.batches[index + 1]?.start ?? Infinity];
      if (end - start > SHORTEST_REST) {
        yield { start, end, limit: this.sample(batch, batch.count - 1).limit };
      }
    }
  }

  /** Returns the samples after a time, without their joints. */
  *after(t: number): Generator<Omit<Sample, "joints">> {
    for (let at = this.batchAt(t), batch = this.batches[at]; batch !== undefined; at += 1, batch = this.batches[at]) {
      const { times } = this.columns(batch);
      for (let index = upTo(batch.count, (place) => times[place] ?? Infinity, t); index < batch.count; index += 1) {
        yield this.properties(batch, index);
      }
    }
  }

  /** Returns the samples after the first `skipped` ones. The joints are columns, in which a sample has this index. */
  *columnsFrom(skipped: number): Generator<{ sample: Omit<Sample, "joints">; joints: readonly Float64Array[]; index: number }> {
    let left = skipped;
    for (const batch of this.batches) {
      if (left < batch.count) {
        const { joints } = this.columns(batch);
        for (let index = left; index < batch.count; index += 1) {
          yield { sample: this.properties(batch, index), joints, index };
        }
      }
      left = Math.max(0, left - batch.count);
    }
  }

  private recount(): void {
    this.count = this.batches.reduce((sum, { count }) => sum + count, 0);
    this.epoch += 1;
  }

  /** Returns the index of the batch that is valid at a time: the last one that begins up to it, otherwise the first one. */
  private batchAt(t: number): number {
    return Math.max(0, upTo(this.batches.length, (index) => this.batches[index]?.start ?? Infinity, t) - 1);
  }

  /** Returns the rests between the samples of a batch. */
  private restsIn(batch: Batch): readonly Rest[] {
    if (batch.rests === undefined) {
      const { times } = this.columns(batch);
      batch.rests = [];
      for (let index = 1; index < batch.count; index += 1) {
        const [start, end] = [times[index - 1] ?? 0, times[index] ?? 0];
        if (end - start > SHORTEST_REST) {
          batch.rests.push({ start, end, limit: this.sample(batch, index - 1).limit });
        }
      }
    }
    return batch.rests;
  }

  private sample(batch: Batch, index: number): Sample {
    const { joints } = this.columns(batch);
    return { ...this.properties(batch, index), joints: joints.map((column) => column[index] ?? 0) };
  }

  private properties(batch: Batch, index: number): Omit<Sample, "joints"> {
    const { times, speeds, origins } = this.columns(batch);
    const { phase = 0, tool = 0, limit = 0, source } = origins.find(({ end }) => index < end) ?? {};
    return { t: times[index] ?? 0, speed: speeds[index] ?? 0, phase, tool, source, limit };
  }

  private columns(batch: Batch): SampleColumns {
    if (this.decoded?.batch !== batch) {
      this.decoded = { batch, columns: batch.columns() };
    }
    return this.decoded.columns;
  }
}

/** Batch in the form of the connection, with the times of the first and the last sample. */
class Batch {
  readonly start: number;
  end: number;
  /** Number of samples that were not discarded. */
  count: number;
  /** Rests between the samples, if they were computed. */
  rests: Rest[] | undefined;
  isState = false;

  /** `encodedCount` is the number of samples in the bytes, which decoding needs also after samples were discarded. */
  private constructor(private readonly bytes: Uint8Array, private readonly axes: number, private readonly encodedCount: number) {
    this.count = encodedCount;
    this.start = firstTime(bytes);
    this.end = timesOf(bytes, encodedCount).at(-1) ?? this.start;
  }

  static from(bytes: Uint8Array): Batch | undefined {
    const head = headOf(bytes);
    return head && new Batch(bytes, head.axes, head.count);
  }

  columns(): SampleColumns {
    return columnsOf(this.bytes, this.encodedCount, this.axes);
  }

  cut(t: number): void {
    const times = timesOf(this.bytes, this.count);
    this.rests = undefined;
    this.count = upTo(this.count, (index) => times[index] ?? Infinity, t);
    this.end = times[this.count - 1] ?? this.start;
  }
}

/** Returns how many of `count` ascending times are up to a time. */
function upTo(count: number, time: (index: number) => number, t: number): number {
  let [low, high] = [0, count];
  while (low < high) {
    const middle = (low + high) >> 1;
    if (time(middle) <= t) {
      low = middle + 1;
    } else {
      high = middle;
    }
  }
  return low;
}
