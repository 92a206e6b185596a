// Moves that were refused immediately, because the arm cannot execute them.

import type { MoveEvent } from "./moves";

export type RefusedMove = Pick<MoveEvent, "type" | "program" | "line"> & { target: readonly number[] };

/** A refused move and the time at which the program has continued. */
type Refusal = RefusedMove & { t: number; until: number };

export class RefusedMoves {
  private readonly all: Refusal[] = [];

  add({ t, phase, type, program, line, target }: MoveEvent): void {
    const last = this.all.at(-1);
    if (phase === "error" && target !== undefined) {
      this.all.push({ t, until: Infinity, type, program, line, target });
    } else if ((phase === "recorded" || phase === "reset") && last !== undefined) {
      last.until = Math.min(last.until, t);
    }
  }

  clear(): void {
    this.all.length = 0;
  }

  /** Returns the moves refused up to a time, unless further moves were recorded or all were discarded since. */
  at(t: number): readonly RefusedMove[] {
    return this.all.filter((move) => move.t <= t && t < move.until);
  }
}
