// Batch of samples in the form of the connection: columns of differences, as docs/src/view.md describes.

/** Kind of the message, axes, two bytes, and the number of samples. */
const HEADER = 8;

/** Source of a sample without a line. */
const NO_SOURCE = 65535;

/** Encoded units per second, per degree or mm, and per mm/s. */
const [TIME_UNITS, JOINT_UNITS, SPEED_UNITS] = [1e9, 1e6, 100];

/** Order of differences: of columns that change steadily, and of the joint columns. */
const [STEADY, ACCELERATED] = [2, 3];

/** Smallest number of bytes for a sample without joints: the differences of time and speed. */
const SMALLEST = 2;

/** Decoded batch: a column for each property. */
export interface SampleColumns {
  times: Float64Array;
  joints: readonly Float64Array[];
  speeds: Float64Array;
  origins: readonly OriginRun[];
}

/** Samples with the same origin, up to an index. */
export interface OriginRun {
  end: number;
  phase: number;
  tool: number;
  limit: number;
  source: number | undefined;
}

/** Returns the number of samples and axes of a message; `undefined` for other messages and damaged ones. */
export function headOf(bytes: Uint8Array): { count: number; axes: number } | undefined {
  if (bytes.length < HEADER || bytes[0] !== 1) {
    return undefined;
  }
  const [axes, count] = [bytes[1] ?? 0, new DataView(bytes.buffer, bytes.byteOffset).getUint32(4, true)];
  return count * (SMALLEST + axes) <= bytes.length - HEADER ? { count, axes } : undefined;
}

/** Decodes the first time of a batch, in s. */
export function firstTime(bytes: Uint8Array): number {
  return new Reader(bytes, HEADER).difference() / TIME_UNITS;
}

/** Decodes the times of a batch, in s. */
export function timesOf(bytes: Uint8Array, count: number): Float64Array {
  return new Reader(bytes, HEADER).column(count, STEADY, TIME_UNITS);
}

export function columnsOf(bytes: Uint8Array, count: number, axes: number): SampleColumns {
  const reader = new Reader(bytes, HEADER);
  const times = reader.column(count, STEADY, TIME_UNITS);
  const joints = Array.from({ length: axes }, () => reader.column(count, ACCELERATED, JOINT_UNITS));
  const speeds = reader.column(count, STEADY, SPEED_UNITS);
  return { times, joints, speeds, origins: reader.origins(count) };
}

class Reader {
  constructor(private readonly bytes: Uint8Array, private at: number) {}

  /** Reads a number in groups of seven bits, the lowest first. Numbers may be larger than 32 bits. */
  number(): number {
    let [value, scale, byte] = [0, 1, 0x80];
    while (byte >= 0x80 && this.at < this.bytes.length) {
      byte = this.bytes[this.at] ?? 0;
      this.at += 1;
      value += (byte & 0x7f) * scale;
      scale *= 128;
    }
    return value;
  }

  /** Reads a number with a sign: 0, 1, 2, 3 … are 0, -1, 1, -2 …. */
  difference(): number {
    const number = this.number();
    return number % 2 === 0 ? number / 2 : -(number + 1) / 2;
  }

  column(count: number, order: number, units: number): Float64Array {
    const column = new Float64Array(count);
    // Differences of the previous value by their order; the first one is the value. The order is at most 3.
    let [value, first, second] = [0, 0, 0];
    for (let index = 0; index < count; index += 1) {
      const difference = this.difference();
      switch (Math.min(index, order)) {
        case 0: value = difference; break;
        case 1: first = difference; value += first; break;
        case 2: second = difference; first += second; value += first; break;
        default: second += difference; first += second; value += first;
      }
      column[index] = value / units;
    }
    return column;
  }

  origins(count: number): OriginRun[] {
    const runs: OriginRun[] = [];
    for (let end = 0; end < count && this.at < this.bytes.length;) {
      end += this.number();
      const [phase = 0, tool = 0, limit = 0] = this.bytes.subarray(this.at, this.at + 3);
      this.at += 3;
      const source = this.number();
      runs.push({ end, phase, tool, limit, source: source === NO_SOURCE ? undefined : source });
    }
    return runs;
  }
}
