// Targets of refused moves, and of recorded moves whose path the arm cannot follow, as crosses with the instruction.

import { Color } from "three";
import type { QueuedMove } from "../panels/shared/cell";
import type { Fault } from "../panels/tasks/faults";
import { countUpTo } from "../panels/tasks/upTo";
import type { Label } from "./Labels";
import { Lines } from "./lines";
import type { Look } from "./palette";

type FailedMove = Pick<QueuedMove, "type" | "target" | "program" | "line">;

export class FailedTargets {
  private readonly lines = new Lines({ width: 4, isOnTop: true });
  readonly object = this.lines.object;
  labels: Label[] = [];

  /** Draws crosses with arms of this length in mm. */
  place(moves: readonly FailedMove[], size: number, look: Look): void {
    const { r, g, b } = new Color(look.unreachable);
    const { segments } = this.lines;
    segments.clear();
    for (const { target: [x = 0, y = 0, z = 0] } of moves) {
      for (const [dx, dy] of [[size, size], [size, -size]] as const) {
        segments.add([x - dx, y - dy, z - size], [x + dx, y + dy, z + size], [r, g, b]);
        segments.add([x - dx, y - dy, z + size], [x + dx, y + dy, z - size], [r, g, b]);
      }
    }
    this.lines.show();
    this.labels = moves.map(({ type, program, line, target }) => ({ text: `${type ?? "move"} at ${program}:${line} fails`, at: target, kind: "failed" }));
  }
}

/** Returns the recorded moves whose faults were reported up to a time. */
export function failedMoves<Move extends Pick<QueuedMove, "id">>(queue: readonly Move[], faults: readonly Fault[], t: number): Move[] {
  const failed = new Set(faults.slice(0, countUpTo(faults, t)).map(({ move }) => move));
  return queue.filter(({ id }) => failed.has(id));
}
