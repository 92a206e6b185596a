// Messages of a run: the parts that the panels use.

import type { SignalInfo, SignalState } from "../io/signalRows";
import type { ArmChain } from "../pendant/armModel";
import type { PointName } from "../points/edits";
import type { TaskState } from "../tasks/chart";
import type { RunEvent } from "../tasks/eventText";
import type { CellPage, CellPoint, Pose } from "./cell";

export interface SceneMessage {
  arm: ArmChain;
  base: Pose;
  frames: readonly { name: string; father: string | null; pose: Pose }[];
  points: readonly CellPoint[];
  signals: readonly SignalInfo[];
  lines: readonly { link: string; type: string }[];
}

export interface QueueEntry {
  id: number;
  type: string;
  source: number;
  phase: string;
  target: Pose;
  leave: Pose | null;
  reach: Pose | null;
  leaveDistance: number | null;
  reachDistance: number | null;
  blendCutShort?: string | null | undefined;
}

export interface StateMessage {
  t: number;
  tasks: readonly TaskState[];
  power: boolean;
  mode: string;
  emergencyStop: string;
  isHeld: boolean;
  /** Why the arm that a task waits for does not move, as sentences for an operator. Absent in runs of earlier versions. */
  awaitedHold?: string | null | undefined;
  monitorSpeed: number;
}

/** Piece of the tool centre point's path ahead. */
export interface WayPiece {
  phase: string;
  points: readonly Pose[];
}

export interface MotionMessage {
  t: number;
  queue: readonly QueueEntry[];
  path: readonly WayPiece[];
}

export interface IoMessage {
  t: number;
  changes: readonly ({ link: string } & SignalState)[];
}

export type PageMessage = { t: number } & CellPage;

export interface DataMessage {
  t: number;
  points: readonly { name: string; key: string | null; pose: Pose; local: Pose }[];
}

/** Points that were changed by hand and not saved. */
export interface UnsavedMessage {
  points: readonly PointName[];
}

export interface EventsMessage {
  events: readonly RunEvent[];
}
