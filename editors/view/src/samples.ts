// Samples of the arm, in chronological order.

/** Source of a sample without a line. */
const NO_SOURCE = 65535;
const HEADER = 8;

export interface Sample {
  t: number;
  joints: readonly number[];
  moveId: number;
  speed: number;
  phase: number;
  tool: number;
  source: number | undefined;
  /** Speed limit, an index into `limits` of the scene. */
  limit: number;
}

/** Time span in which the arm stands. The last one has no end yet. */
export interface Rest {
  start: number;
  end: number;
  /** Speed limit that holds the arm, an index into `limits` of the scene. */
  limit: number;
}

/** Shortest time without samples that is a rest: more than a few cycles, in s. */
const SHORTEST_REST = 0.02;

/** Batches of samples as received; a sample is decoded when it is read. */
export class Samples {
  private readonly batches: Batch[] = [];
  count = 0;

  /** Adds a batch. Other messages than samples are ignored. */
  add(buffer: ArrayBuffer): number | undefined {
    const batch = Batch.from(buffer);
    if (batch === undefined || batch.count === 0) {
      return undefined;
    }
    this.batches.push(batch);
    this.count += batch.count;
    return batch.time(batch.count - 1);
  }

  clear(): void {
    this.batches.length = 0;
    this.count = 0;
  }

  /** Discards the samples after a time. */
  cut(t: number): void {
    while ((this.batches.at(-1)?.time(0) ?? -Infinity) > t) {
      this.batches.pop();
    }
    this.batches.at(-1)?.cut(t);
    this.count = this.batches.reduce((sum, { count }) => sum + count, 0);
  }

  /** Returns the time in the middle of the samples. */
  middle(): number {
    return this.batches[this.batches.length >> 1]?.time(0) ?? 0;
  }

  /** Discards the batches before the batch that is valid at a time. */
  drop(t: number): void {
    const first = this.batches.findIndex((_, index) => (this.batches[index + 1]?.time(0) ?? Infinity) > t);
    this.batches.splice(0, first);
    this.count = this.batches.reduce((sum, { count }) => sum + count, 0);
  }

  /** Returns the sample at a time: the last one up to it, otherwise the first one. */
  at(t: number): Sample | undefined {
    let [low, high] = [0, this.batches.length];
    while (low < high) {
      const middle = (low + high) >> 1;
      if ((this.batches[middle]?.time(0) ?? Infinity) <= t) {
        low = middle + 1;
      } else {
        high = middle;
      }
    }
    const batch = this.batches[Math.max(0, low - 1)];
    return batch?.sample(batch.lastUpTo(t));
  }

  /** Returns the rests of the arm, for which no samples are sent. */
  *rests(): Generator<Rest> {
    for (const [index, batch] of this.batches.entries()) {
      yield* batch.rests();
      const [start, end] = [batch.time(batch.count - 1), this.batches[index + 1]?.time(0) ?? Infinity];
      if (end - start > SHORTEST_REST) {
        yield { start, end, limit: batch.sample(batch.count - 1).limit };
      }
    }
  }

  all(): Generator<Sample> {
    return this.from(0);
  }

  /** Returns the samples after the first `skipped` ones. */
  *from(skipped: number): Generator<Sample> {
    let left = skipped;
    for (const batch of this.batches) {
      for (let index = left; index < batch.count; index += 1) {
        yield batch.sample(index);
      }
      left = Math.max(0, left - batch.count);
    }
  }
}

/** Batch: `u8 1, u8 axes, u16, u32 count`, then the samples, little endian. */
class Batch {
  private readonly size: number;
  private found: Rest[] | undefined;

  private constructor(private readonly view: DataView, private readonly axes: number, public count: number) {
    this.size = 8 + 8 * axes + 8 + 4 + 1 + 1 + 2 + 1;
  }

  static from(buffer: ArrayBuffer): Batch | undefined {
    const view = new DataView(buffer);
    if (buffer.byteLength < HEADER || view.getUint8(0) !== 1) {
      return undefined;
    }
    const batch = new Batch(view, view.getUint8(1), view.getUint32(4, true));
    batch.count = Math.min(batch.count, Math.floor((buffer.byteLength - HEADER) / batch.size));
    return batch;
  }

  time(index: number): number {
    return this.view.getFloat64(HEADER + index * this.size, true);
  }

  /** Returns the rests between the samples of the batch. */
  rests(): readonly Rest[] {
    this.found ??= Array.from({ length: Math.max(0, this.count - 1) }, (_, index) => index)
      .filter((index) => this.time(index + 1) - this.time(index) > SHORTEST_REST)
      .map((index) => ({ start: this.time(index), end: this.time(index + 1), limit: this.sample(index).limit }));
    return this.found;
  }

  cut(t: number): void {
    this.found = undefined;
    while (this.count > 0 && this.time(this.count - 1) > t) {
      this.count -= 1;
    }
  }

  lastUpTo(t: number): number {
    let [low, high] = [0, this.count];
    while (low < high) {
      const middle = (low + high) >> 1;
      if (this.time(middle) <= t) {
        low = middle + 1;
      } else {
        high = middle;
      }
    }
    return Math.max(0, low - 1);
  }

  sample(index: number): Sample {
    const start = HEADER + index * this.size;
    const { view, axes } = this;
    const rest = start + 8 + 8 * axes;
    const source = view.getUint16(rest + 14, true);
    return {
      t: this.time(index),
      joints: Array.from({ length: axes }, (_, axis) => view.getFloat64(start + 8 + 8 * axis, true)),
      moveId: view.getFloat64(rest, true),
      speed: view.getFloat32(rest + 8, true),
      phase: view.getUint8(rest + 12),
      tool: view.getUint8(rest + 13),
      source: source === NO_SOURCE ? undefined : source,
      limit: view.getUint8(rest + 16),
    };
  }
}
