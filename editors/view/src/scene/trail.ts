// Path that the tool centre point has travelled, coloured by phase.

import { signal } from "@preact/signals";
import { Color } from "three";
import type { Chain } from "../kinematics";
import type { Frame } from "../panels/pendant/pose";
import { countUpTo } from "../panels/tasks/upTo";
import type { Sample, Samples } from "../samples";
import { ToolPositions } from "../toolPositions";
import { Lines } from "./lines";
import { phaseColour } from "./palette";
import type { Colour, Segments } from "./segments";
import { ThinLines } from "./thinLines";

/** Limits of a straight piece with the same line and phase: duration in s, and distance from the path in mm. */
const LONGEST = 0.2;
const NEAR = 0.2;

/** Number of samples after which the time is read. */
const CHECKED = 1000;

/** Largest number of drawn pieces. Above it, the older half is simplified. */
const MOST = 60_000;

/** Number of pieces above which the oldest are discarded after the older half was simplified. */
const KEPT = (MOST * 3) / 4;

/** Limits of a simplified piece: duration in s, and distance of the path from it in mm. */
export const LONGEST_OLD = 1;
export const NEAR_OLD = 2;

/**
 * Number of pieces before the shown time that are drawn as wide lines. Without a graphics card, ten minutes of motion
 * needed 490 ms per frame as wide lines, and 60 ms with thin lines.
 */
const WIDE = 800;

/** Distance by which the box around the path is larger, so that it grows seldom, in mm. */
const MARGIN = 20;

type Position = readonly [number, number, number];

/** Properties of a sample that the path shows. */
type PathSample = Omit<Sample, "joints">;

/** Straight piece of the path, from one time to another. */
export interface Piece {
  from: number;
  t: number;
  source: number | undefined;
  phase: number;
  speed: number;
  /** Speed limit, an index into `limits` of the scene. */
  limit: number;
  /** Largest distance of the path from the piece, in mm. */
  off: number;
}

export class Trail {
  private readonly all = new ThinLines();
  private readonly recent = new Lines({ width: 2.6 });
  readonly objects = [this.all.object, this.all.rest, this.recent.object];
  readonly segments: Segments = this.all.segments;
  /** Phases of all pieces, as indices. */
  readonly occurring = signal<ReadonlySet<number>>(new Set());
  /** Number of completely shown pieces. */
  shown = 0;
  /** Number of times that the box around the path has grown. */
  growth = 0;
  private readonly box: { min: number[]; max: number[] } = { min: [], max: [] };
  private readonly pieces: Piece[] = [];
  private phases: readonly string[] = [];
  private taken = 0;
  /** Epoch of the added samples. If the samples have another epoch, the path is built again. */
  private epoch = 0;
  private last: { sample: PathSample; position: Position } | undefined;
  /** Positions that the last piece represents. */
  private straight: Position[] = [];

  /**
   * Adds the new samples, at most for a time in ms. Returns whether all are added. `toolOf` returns the tool for an index.
   */
  follow(samples: Samples, arm: Chain, base: Frame, phases: readonly string[], toolOf: (index: number) => readonly number[], most = Infinity): boolean {
    this.phases = phases;
    if (samples.epoch !== this.epoch) {
      this.clear();
      this.epoch = samples.epoch;
    }
    if (samples.count === this.taken) {
      return true;
    }
    const positions = new ToolPositions(arm, base);
    const end = performance.now() + most;
    for (const { index, joints, sample } of samples.columnsFrom(this.taken)) {
      this.add(sample, positions.at(joints, index, toolOf(sample.tool)));
      this.taken += 1;
      if (this.taken % CHECKED === 0 && performance.now() > end) {
        break;
      }
    }
    return samples.count === this.taken;
  }

  clear(): void {
    this.segments.clear();
    this.pieces.length = 0;
    this.occurring.value = new Set();
    this.taken = 0;
    this.last = undefined;
    this.straight = [];
    this.box.min = [];
    this.box.max = [];
  }

  /** Shows the path up to a time. */
  showUpTo(t: number): void {
    this.shown = countUpTo(this.pieces, t + 1e-9);
    this.all.show(this.shown);
    const wide = this.recent.segments;
    wide.clear();
    for (let index = Math.max(0, this.shown - WIDE); index < this.shown; index += 1) {
      wide.add(...this.segments.at(index));
    }
    const begun = this.pieces[this.shown];
    if (begun !== undefined && begun.from < t) {
      const [from, to, colour] = this.segments.at(this.shown);
      const share = (t - begun.from) / (begun.t - begun.from);
      wide.add(from, from.map((start, axis) => start + ((to[axis] ?? 0) - start) * share), colour);
    }
    this.recent.show();
  }

  piece(index: number): Piece | undefined {
    return this.pieces[index];
  }

  private colour(phase: number): Colour {
    const { r, g, b } = new Color(phaseColour(this.phases[phase]));
    return [r, g, b];
  }

  private add(sample: PathSample, position: Position): void {
    const { last } = this;
    if (last?.sample.tool === sample.tool) {
      const from = this.straight[0] ?? last.position;
      const piece = this.pieces.at(-1);
      const isSame = piece?.phase === sample.phase && piece.source === sample.source && sample.t - piece.from < LONGEST;
      if (isSame && this.straight.length > 0 && farthest(from, position, this.straight) < NEAR) {
        this.straight.push(position);
        this.segments.end(position);
        Object.assign(piece, { t: sample.t, speed: sample.speed, limit: sample.limit });
      } else if (distance(last.position, position) > 1e-6) {
        this.segments.add(last.position, position, this.colour(sample.phase));
        this.pieces.push({ from: last.sample.t, t: sample.t, source: sample.source, phase: sample.phase, speed: sample.speed, limit: sample.limit, off: NEAR });
        this.straight = [last.position, position];
        this.mention(sample.phase);
        this.surround(last.position);
        this.surround(position);
        this.thin();
      }
    } else {
      this.straight = [];
    }
    this.last = { sample, position };
  }

  /** Returns the ends of the pieces, at most about two thousand. */
  *positions(): Generator<Position> {
    const step = Math.ceil(Math.max(this.pieces.length, 1) / 1000);
    for (let index = 0; index < this.pieces.length; index += step) {
      const [from, to] = this.segments.at(index);
      yield positionOf(from);
      yield positionOf(to);
    }
  }

  private surround(position: Position): void {
    const { min, max } = this.box;
    const isOutside = position.some((value, axis) => value < (min[axis] ?? Infinity) || value > (max[axis] ?? -Infinity));
    if (isOutside) {
      this.box.min = position.map((value, axis) => Math.min(value, min[axis] ?? Infinity) - MARGIN);
      this.box.max = position.map((value, axis) => Math.max(value, max[axis] ?? -Infinity) + MARGIN);
      this.growth += 1;
    }
  }

  private mention(phase: number): void {
    if (!this.occurring.peek().has(phase)) {
      this.occurring.value = new Set([...this.occurring.peek(), phase]);
    }
  }

  /** Bounds the number of pieces: simplifies the older half, and discards the oldest pieces if too many remain. */
  private thin(): void {
    if (this.pieces.length <= MOST) {
      return;
    }
    const older = this.pieces.splice(0, MOST / 2);
    const { kept, isJoined } = simplified(older, this.segments);
    this.pieces.unshift(...kept);
    this.segments.join(isJoined);
    const surplus = Math.max(0, this.pieces.length - KEPT);
    this.pieces.splice(0, surplus);
    this.segments.drop(surplus);
  }
}

/** Merges successive pieces of the same line and phase that are nearly straight. `isJoined` marks each piece that extends the one before it. */
function simplified(pieces: readonly Piece[], segments: Segments): { kept: Piece[]; isJoined: boolean[] } {
  const kept: Piece[] = [];
  const isJoined: boolean[] = [];
  /** Start of the last kept piece, and its piece ends. */
  let [start, ends]: [Position, Position[]] = [[0, 0, 0], []];
  /** Largest distance of the path from the pieces in the last kept piece. */
  let off = 0;
  for (const [index, piece] of pieces.entries()) {
    const before = kept.at(-1);
    const [from, to] = segments.at(index);
    const end = positionOf(to);
    const isContinued = before !== undefined && before.t === piece.from && before.phase === piece.phase && before.source === piece.source && piece.t - before.from <= LONGEST_OLD;
    const widest = Math.max(off, piece.off);
    const total = isContinued ? widest + farthest(start, end, ends) : Infinity;
    isJoined.push(total <= NEAR_OLD);
    if (before !== undefined && total <= NEAR_OLD) {
      kept[kept.length - 1] = { ...piece, from: before.from, off: total };
      ends.push(end);
      off = widest;
    } else {
      kept.push(piece);
      [start, ends, off] = [positionOf(from), [end], piece.off];
    }
  }
  return { kept, isJoined };
}

function positionOf([x = 0, y = 0, z = 0]: ArrayLike<number> & Iterable<number>): Position {
  return [x, y, z];
}

function distance(from: Position, to: Position): number {
  return Math.hypot(to[0] - from[0], to[1] - from[1], to[2] - from[2]);
}

/** Returns the largest distance of positions from the line between two positions, in mm. */
function farthest(from: Position, to: Position, between: readonly Position[]): number {
  const [x, y, z] = [to[0] - from[0], to[1] - from[1], to[2] - from[2]];
  const square = Math.max(x * x + y * y + z * z, 1e-12);
  let largest = 0;
  for (const position of between) {
    const [dx, dy, dz] = [position[0] - from[0], position[1] - from[1], position[2] - from[2]];
    const share = Math.min(Math.max((dx * x + dy * y + dz * z) / square, 0), 1);
    const [ox, oy, oz] = [dx - x * share, dy - y * share, dz - z * share];
    largest = Math.max(largest, ox * ox + oy * oy + oz * oz);
  }
  return Math.sqrt(largest);
}
