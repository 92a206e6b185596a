// The moves ahead, as the message of the state has them.

import type { Store } from "../store";

export interface Motion {
  path: readonly Piece[];
  queue: readonly Corner[];
}

/** A piece of the way ahead of the tool centre point. */
export interface Piece {
  phase: string;
  points: readonly (readonly number[])[];
}

interface Corner {
  target: readonly number[];
  leave: readonly number[] | null;
  reach: readonly number[] | null;
  leaveDistance: number | null;
  reachDistance: number | null;
}

/** The motion at the shown time. */
export function motionOf(store: Store): Motion {
  const state = store.panels.cell.state.value as Partial<Motion> | undefined;
  return { path: state?.path ?? [], queue: state?.queue ?? [] };
}

/** The spheres in which the arm leaves and reaches the ways between points. */
export function spheresOf(queue: readonly Corner[]): { at: readonly number[]; radius: number; kind: "leave" | "reach" }[] {
  return queue.flatMap(({ target, leaveDistance, reachDistance }) =>
    ([["leave", leaveDistance], ["reach", reachDistance]] as const).flatMap(([kind, radius]) => (radius !== null && radius > 0 ? [{ at: target, radius, kind }] : [])));
}
