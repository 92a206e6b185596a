// Moves of the arm from their events: the times at which each move was recorded, started, blended and done.

export interface MoveTimes {
  id: number;
  type: string;
  program: string;
  line: number;
  recorded: number | undefined;
  started: number | undefined;
  /** Time at the leave point, where the blend into the next move begins. */
  blend: number | undefined;
  done: number | undefined;
  /** Whether the queue contained a leave point for the move. */
  hasLeave: boolean;
}

export interface MoveEvent {
  t: number;
  id: number;
  phase: string;
  type: string;
  program: string;
  line: number;
  /** Position of the target in mm, if the move was refused. */
  target?: readonly number[];
}

/** All moves in the order of recording. */
export class Moves {
  private readonly byId = new Map<number, Omit<MoveTimes, "hasLeave">>();
  private readonly leaving = new Set<number>();

  add({ t, id, phase, type, program, line }: MoveEvent): void {
    if (!["recorded", "started", "blend", "reached", "done"].includes(phase)) {
      return;
    }
    const move = this.byId.get(id) ?? { id, type, program, line, recorded: undefined, started: undefined, blend: undefined, done: undefined };
    this.byId.set(id, move);
    if (phase !== "reached") {
      move[phase as "recorded" | "started" | "blend" | "done"] ??= t;
    }
  }

  /** Adds the leave point of a queued move. */
  addQueued({ id, leaveDistance }: { id: number; leaveDistance?: number | null | undefined }): void {
    if ((leaveDistance ?? 0) > 0) {
      this.leaving.add(id);
    }
  }

  clear(): void {
    this.byId.clear();
    this.leaving.clear();
  }

  all(): MoveTimes[] {
    const moves = [...this.byId.values()].map((move) => ({ ...move, hasLeave: this.leaving.has(move.id) }));
    return moves.sort((left, right) => left.id - right.id);
  }
}

/** Move that stopped at its target although it has a blend. */
export interface CutBlend {
  move: MoveTimes;
  /** Delay of the next move in s; `undefined` if no move followed. */
  delay: number | undefined;
}

/** Returns the moves without their blend up to a time. */
export function cutBlends(moves: readonly MoveTimes[], end: number): CutBlend[] {
  return moves.flatMap((move, index) => {
    const { hasLeave, blend, done } = move;
    if (!hasLeave || blend !== undefined || done === undefined || done > end) {
      return [];
    }
    const next = moves[index + 1]?.recorded;
    return [{ move, delay: next === undefined || next > end ? undefined : Math.max(0, next - done) }];
  });
}

export function cutText({ move, delay }: CutBlend): string {
  const reason = delay === undefined ? "no move followed" : `the next move was recorded ${delay.toFixed(3)} s after its end`;
  return `${move.type} at ${move.program}:${move.line} stopped at its target: ${reason}.`;
}

/** Shortest wait of the arm in a move that the chart shows, in s. Live samples may be late by less. */
const SHORTEST_WAIT = 0.25;

/** Returns the parts of rests in which a move has started and is not done: the arm waits, for example for the next move. */
export function waitsInMoves<Span extends { start: number; end: number }>(rests: Iterable<Span>, moves: readonly MoveTimes[], time: number): Span[] {
  const begun = moves.filter(({ started = Infinity }) => started <= time);
  let first = 0;
  return [...rests].flatMap((rest) => {
    // Rests and moves are in chronological order.
    while ((begun[first]?.done ?? Infinity) <= rest.start) {
      first += 1;
    }
    const waits: Span[] = [];
    for (let index = first; (begun[index]?.started ?? Infinity) < rest.end; index += 1) {
      const { started = Infinity, done = Infinity } = begun[index] ?? {};
      const wait = { ...rest, start: Math.max(rest.start, started), end: Math.min(rest.end, done) };
      if (Math.min(wait.end, time) - wait.start >= SHORTEST_WAIT) {
        waits.push(wait);
      }
    }
    return waits;
  });
}
