// Messages of a run: the parts that the panels use.

import type * as wire from "../../wire";
import type { CellPage, CellPoint, CellScene, CellState, JointValue } from "./cell";

export type SceneMessage = CellScene;

/** Recorded move. Runs of earlier versions have no `blendCutShort`. */
export type QueueEntry = Omit<wire.QueueEntry, "blend" | "blendCutShort"> & { blendCutShort?: string | null | undefined };

export type StateMessage = Pick<wire.StateMessage, "t"> & CellState;

/** Piece of the tool centre point's path ahead. */
export type WayPiece = wire.WayPiece;

export type MotionMessage = Omit<wire.MotionMessage, "queue"> & { queue: readonly QueueEntry[] };

export type IoMessage = wire.IoMessage;

export type PageMessage = Pick<wire.PageMessage, "t"> & CellPage;

/** Changed values. Runs of earlier versions have only points. */
export type DataMessage = Pick<wire.DataMessage, "t"> & { points: readonly Omit<CellPoint, "father">[]; joints?: readonly JointValue[] | undefined; frames?: readonly CellPoint[] | undefined; tools?: readonly CellPoint[] | undefined };

/** Changed data. Runs of earlier versions have no `undo`. */
export type UnsavedMessage = Pick<wire.UnsavedMessage, "points"> & { undo?: wire.PointName | null | undefined };

export type PartsMessage = wire.PartsMessage;

export type ProgramsMessage = wire.ProgramsMessage;

export type ReachMessage = wire.ReachMessage;

export type EventsMessage = wire.EventsMessage;
