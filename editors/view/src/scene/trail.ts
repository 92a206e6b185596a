// The path that the tool centre point has travelled, coloured by phases.

import { Color } from "three";
import { armFrames, type Chain } from "../kinematics";
import { composed, type Frame, frameOf } from "../panels/pendant/pose";
import type { Sample, Samples } from "../samples";
import { Lines } from "./lines";
import { phaseColour } from "./palette";

/** Shorter ways of one line and phase are drawn as one, in mm. */
const SHORT = 0.5;

export interface Piece {
  t: number;
  source: number | undefined;
  phase: number;
  speed: number;
}

export class Trail {
  readonly lines = new Lines({ width: 2.6 });
  private readonly pieces: Piece[] = [];
  private taken = 0;
  private last: { sample: Sample; position: readonly number[] } | undefined;

  /** Follows the samples; `toolOf` gives the tool of an index. */
  follow(samples: Samples, arm: Chain, base: Frame, phases: readonly string[], toolOf: (index: number) => readonly number[]): void {
    if (samples.count < this.taken) {
      this.clear();
    }
    for (const sample of samples.from(this.taken)) {
      const { flange } = armFrames(arm, base, sample.joints);
      this.add(sample, composed(flange, frameOf(toolOf(sample.tool))).position, phases);
    }
    this.taken = samples.count;
  }

  clear(): void {
    this.lines.clear();
    this.pieces.length = 0;
    this.taken = 0;
    this.last = undefined;
  }

  /** Shows the path up to a time. */
  showUpTo(t: number): void {
    let [low, high] = [0, this.pieces.length];
    while (low < high) {
      const middle = (low + high) >> 1;
      if ((this.pieces[middle]?.t ?? Infinity) <= t + 1e-9) {
        low = middle + 1;
      } else {
        high = middle;
      }
    }
    this.lines.show(low);
  }

  piece(index: number): Piece | undefined {
    return this.pieces[index];
  }

  private add(sample: Sample, position: readonly [number, number, number], phases: readonly string[]): void {
    const { last } = this;
    if (last?.sample.tool === sample.tool) {
      const way = Math.hypot(...position.map((value, at) => value - (last.position[at] ?? 0)));
      const isSame = last.sample.phase === sample.phase && last.sample.source === sample.source;
      if (way < (isSame ? SHORT : 1e-6)) {
        return;
      }
      const { r, g, b } = new Color(phaseColour(phases[sample.phase]));
      this.lines.add(last.position, position, [r, g, b]);
      this.pieces.push({ t: sample.t, source: sample.source, phase: sample.phase, speed: sample.speed });
    }
    this.last = { sample, position };
  }
}
