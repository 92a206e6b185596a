// Coloured segments in two arrays that grow.

/** Numbers per segment: its start and its end. */
export const SIZE = 6;

export type Colour = readonly [r: number, g: number, b: number];

export class Segments {
  positions = new Float32Array(64 * SIZE);
  colours = new Float32Array(64 * SIZE);
  count = 0;
  /** First segment that has changed since `changed` was last set to the count. */
  changed = 0;

  add(from: ArrayLike<number>, to: ArrayLike<number>, [r, g, b]: Colour): void {
    if ((this.count + 1) * SIZE > this.positions.length) {
      this.positions = grown(this.positions);
      this.colours = grown(this.colours);
    }
    this.positions.set([from[0] ?? 0, from[1] ?? 0, from[2] ?? 0, to[0] ?? 0, to[1] ?? 0, to[2] ?? 0], this.count * SIZE);
    this.colours.set([r, g, b, r, g, b], this.count * SIZE);
    this.count += 1;
  }

  /** Moves the end of the last segment. */
  end(to: ArrayLike<number>): void {
    this.positions.set([to[0] ?? 0, to[1] ?? 0, to[2] ?? 0], this.count * SIZE - 3);
    this.changed = Math.min(this.changed, this.count - 1);
  }

  /** Joins the first segments: a segment that is marked extends the segment before it. */
  join(isJoined: readonly boolean[]): void {
    let kept = 0;
    for (let index = 0; index < this.count; index += 1) {
      const at = index * SIZE;
      if (isJoined[index] === true) {
        this.positions.copyWithin(kept * SIZE - 3, at + 3, at + SIZE);
      } else {
        this.positions.copyWithin(kept * SIZE, at, at + SIZE);
        this.colours.copyWithin(kept * SIZE, at, at + SIZE);
        kept += 1;
      }
    }
    this.count = kept;
    this.changed = 0;
  }

  /** Removes the first segments. */
  drop(count: number): void {
    this.positions.copyWithin(0, count * SIZE, this.count * SIZE);
    this.colours.copyWithin(0, count * SIZE, this.count * SIZE);
    this.count -= count;
    this.changed = 0;
  }

  clear(): void {
    this.count = 0;
    this.changed = 0;
  }

  /** Returns the start, the end and the colour of a segment. */
  at(index: number): readonly [Float32Array, Float32Array, Colour] {
    const at = index * SIZE;
    const { positions, colours } = this;
    return [positions.subarray(at, at + 3), positions.subarray(at + 3, at + SIZE), [colours[at] ?? 0, colours[at + 1] ?? 0, colours[at + 2] ?? 0]];
  }
}

function grown(values: Float32Array<ArrayBuffer>): Float32Array<ArrayBuffer> {
  const larger = new Float32Array(values.length * 2);
  larger.set(values);
  return larger;
}
