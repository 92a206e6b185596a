// The view of the cell that the panels need: everything at the shown time, its history, and the commands.

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
  /** The words of its configuration. */
  config?: string | null | undefined;
}

export interface CellScene {
  arm: ArmChain;
  base: Pose;
  frames: readonly { name: string; father: string | null; pose: Pose }[];
  signals: readonly SignalInfo[];
  lines: readonly { link: string; type: string }[];
  /** The points with the values of the files. */
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
  /** Why its blend is shorter than requested; null if it is not. Runs of earlier versions do not have it. */
  blendCutShort?: string | null | undefined;
}

export interface CellState {
  tasks: readonly TaskState[];
  power: boolean;
  mode: string;
  emergencyStop: string;
  isHeld: boolean;
  monitorSpeed: number;
}

/** The recorded moves, and the way ahead. */
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

/** A page made with HTML: the values of its elements, and the programs that a click executes. */
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

/** Everything up to the newest message; rows later than the shown time are not to be shown. */
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
  /** The shown time in seconds, as fine as the picture. */
  time: ReadonlySignal<number>;
  /** The shown time, a few times a second, for tables of the past. */
  slowTime: ReadonlySignal<number>;
  /** The range of time of the chart, and all times up to now. */
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
  /** The reason why nothing can be operated now. */
  blocked: ReadonlySignal<string | undefined>;
  /** The names of points that were changed by hand, and are not saved. */
  unsaved: ReadonlySignal<ReadonlySet<string>>;
  selectedPoint: ReadonlySignal<PointName | undefined>;
  selectPoint: (point: PointName | undefined) => void;
  /** Opens a line in the editor, where there is one. */
  openLine: ReadonlySignal<OpenLine | undefined>;
  send: (command: string, args: object) => Promise<Answer>;
}

/** The last refusal of a panel, shown as a sentence. */
export class Notice {
  readonly text: Signal<string> = signal("");

  /** Sends a command. A refusal becomes the text of the notice. */
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

  /** Operates the cell with the keys of a script. */
  operate(cell: Cell, keys: object): Promise<Answer | undefined> {
    return this.send(cell, "operate", { keys });
  }
}
