// State of the cell that the panels need: at the shown time, with its history, and the commands.

import { type ReadonlySignal, signal, type Signal } from "@preact/signals";
import type { SignalInfo, SignalState } from "../io/signalRows";
import type { SignalHistory } from "../io/sparkline";
import type { Transfer } from "../io/lineBytes";
import type { ArmChain } from "../pendant/armModel";
import type { ModeRun } from "../pendant/pageCells";
import type { PointName } from "../points/edits";
import type { TaskSegments, TaskState } from "../tasks/chart";
import type { RunEvent } from "../tasks/eventText";
import type { Moves } from "../tasks/moves";
import type { TimedPhase, TimedTasks } from "../tasks/times";
import type { WayPiece } from "./messages";

export type Pose = readonly number[];

export interface CellPoint extends PointName {
  father: string | null;
  local: Pose;
  pose: Pose;
  /** Configuration in words. */
  config?: string | null | undefined;
}

export interface CellScene {
  arm: ArmChain;
  base: Pose;
  frames: readonly { name: string; father: string | null; pose: Pose }[];
  signals: readonly SignalInfo[];
  lines: readonly { link: string; type: string }[];
  /** Points with the values in the files. */
  points: readonly CellPoint[];
}

export interface QueuedMove {
  id: number;
  type: string;
  program: string;
  line: number;
  phase: string;
  target: Pose;
  leave: Pose | null;
  reach: Pose | null;
  leaveDistance: number | null;
  reachDistance: number | null;
  /** Reason why the blend is shorter than requested; null if it is not. Absent in runs of earlier versions. */
  blendCutShort?: string | null | undefined;
}

export interface CellState {
  tasks: readonly TaskState[];
  power: boolean;
  mode: string;
  emergencyStop: string;
  isHeld: boolean;
  /** Why the arm that a task waits for does not move, as sentences for an operator. Absent in runs of earlier versions. */
  awaitedHold?: string | null | undefined;
  monitorSpeed: number;
}

/** Recorded moves, and the path ahead. */
export interface CellMotion {
  queue: readonly QueuedMove[];
  path: readonly WayPiece[];
}

export interface CellPage {
  screen: string;
  title: string;
  lines: readonly string[];
  modes?: readonly (readonly ModeRun[])[] | undefined;
  popUp?: string | null | undefined;
  html?: HtmlPage | null | undefined;
}

/** HTML user page: the values of its elements, and the programs that a click executes. */
export interface HtmlPage {
  name: string;
  values: readonly { id: string; attribute: string; value: string | null }[];
  clicks: readonly { id: string; program: string }[];
}

export interface ArmSample {
  joints: readonly number[];
  /** Flange to tool centre point. */
  tool: Pose;
}

/** History up to the newest message. Rows later than the shown time must not be shown. */
export interface CellHistory {
  signals: SignalHistory;
  segments: TaskSegments;
  moves: Moves;
  events: readonly RunEvent[];
  transfers: readonly Transfer[];
  states: readonly TimedTasks[];
  samples: () => Iterable<TimedPhase>;
}

export interface Answer {
  error: string | null;
  [field: string]: unknown;
}

export type OpenLine = (source: { program: string; line: number; file: string }) => void;

export interface Cell {
  scene: ReadonlySignal<CellScene | undefined>;
  /** Shown time in s, updated with each frame of the drawing. */
  time: ReadonlySignal<number>;
  /** Shown time, updated a few times per second, for tables of the history. */
  slowTime: ReadonlySignal<number>;
  /** Time range of the chart, and the entire range up to now. */
  range: ReadonlySignal<readonly [start: number, end: number]>;
  whole: ReadonlySignal<readonly [start: number, end: number]>;
  setRange: (start: number, end: number) => void;
  seek: (t: number) => void;
  state: ReadonlySignal<CellState | undefined>;
  motion: ReadonlySignal<CellMotion>;
  page: ReadonlySignal<CellPage | undefined>;
  levels: ReadonlySignal<ReadonlyMap<string, SignalState>>;
  points: ReadonlySignal<readonly CellPoint[]>;
  sample: ReadonlySignal<ArmSample | undefined>;
  history: CellHistory;
  isPaused: ReadonlySignal<boolean>;
  hasEnded: ReadonlySignal<boolean>;
  /** Reason why nothing can be operated now. */
  blocked: ReadonlySignal<string | undefined>;
  /** Names of points that were changed by hand and not saved. */
  unsaved: ReadonlySignal<ReadonlySet<string>>;
  selectedPoint: ReadonlySignal<PointName | undefined>;
  selectPoint: (point: PointName | undefined) => void;
  /** Opens a line in the editor, if there is one. */
  openLine: ReadonlySignal<OpenLine | undefined>;
  send: (command: string, args: object) => Promise<Answer>;
}

/** Last rejection in a panel, shown as a sentence. */
export class Notice {
  readonly text: Signal<string> = signal("");

  /** Sends a command. If it is rejected, the notice shows the reason. */
  async send(cell: Cell, command: string, args: object): Promise<Answer | undefined> {
    const blocked = cell.blocked.peek();
    if (blocked !== undefined) {
      this.text.value = blocked;
      return undefined;
    }
    try {
      const answer = await cell.send(command, args);
      this.text.value = answer.error ?? "";
      return answer.error === null ? answer : undefined;
    } catch (fault) {
      this.text.value = fault instanceof Error ? fault.message : String(fault);
      return undefined;
    }
  }

  /** Operates the cell with script keys. */
  operate(cell: Cell, keys: object): Promise<Answer | undefined> {
    return this.send(cell, "operate", { keys });
  }
}
