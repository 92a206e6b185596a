// State of the cell that the panels need: at the shown time, with its history, and the commands.

import { type ReadonlySignal, signal, type Signal } from "@preact/signals";
import type { Encounters } from "../clearance/encounters";
import type { SignalInfo, SignalState } from "../io/signalRows";
import type { SignalHistory } from "../io/sparkline";
import type { Transfer } from "../io/lineBytes";
import type { ArmChain } from "../pendant/armModel";
import type { PointName } from "../points/edits";
import type { ToolReach } from "../points/reachQuery";
import type { ChosenTool } from "../points/tools";
import type { TaskSegments, TaskState } from "../tasks/chart";
import type { RunEvent } from "../tasks/eventText";
import type { Fault } from "../tasks/faults";
import type { Moves } from "../tasks/moves";
import type { RefusedMoves } from "../tasks/refusedMoves";
import type { TimedPhases, TimedTasks } from "../tasks/times";
import type { MovingLine } from "../program/marks";
import type { CodeLine, NamedLine } from "../program/programs";
import type { ProgramView } from "../program/ProgramView";
import type * as wire from "../../wire";
import type { QueueEntry, WayPiece } from "./messages";

export type Pose = readonly number[];

/** Point. Runs of earlier versions have no configuration. */
export type CellPoint = Omit<wire.CellPoint, "config"> & { config?: string | null | undefined };

/** Joint position. */
export type JointValue = wire.JointValue;

export type CellScene = Pick<wire.Scene, "base" | "lines"> & {
  /** Length unit of the application's data. Runs of earlier versions have none. */
  lengthUnit?: wire.LengthUnit;
  arm: ArmChain;
  /** Frames with their initial values. */
  frames: readonly CellPoint[];
  signals: readonly SignalInfo[];
  /** Points with their initial values. */
  points: readonly CellPoint[];
  /** Joint positions with their initial values. */
  joints?: readonly JointValue[];
  /** Tools with their initial values. */
  tools?: readonly CellPoint[];
};

/** Recorded move with its line instead of a source index. */
export type QueuedMove = Omit<QueueEntry, "source"> & CodeLine;

/** State of the cell. Runs of earlier versions have no `awaitedHold`, `heldBecause`, `awaitsNextMove` and `config`. */
export type CellState = Omit<wire.StateMessage, "t" | "heldBecause" | "awaitedHold" | "awaitsNextMove" | "config" | "tasks"> & { tasks: readonly TaskState[] } & {
  [Key in "awaitedHold" | "heldBecause" | "awaitsNextMove" | "config"]?: wire.StateMessage[Key] | undefined;
};

/** Recorded moves, and the path ahead. */
export interface CellMotion {
  queue: readonly QueuedMove[];
  path: readonly WayPiece[];
}

/** User page. Runs of earlier versions have no text modes, pop-ups and HTML pages. */
export type CellPage = Pick<wire.PageMessage, "screen" | "title" | "lines"> & {
  [Key in "modes" | "popUp" | "html"]?: wire.PageMessage[Key] | undefined;
};

/** HTML user page: element values, and the programs that a click executes. */
export type HtmlPage = wire.HtmlPage;

export interface ArmSample {
  joints: readonly number[];
  /** Flange to tool centre point. */
  tool: Pose;
  /** Name of the tool, if data have its pose. */
  toolName?: string | null | undefined;
}

/** Position to which the operator is about to move the arm, and its name. */
export interface ArmGoal {
  joints: readonly number[];
  text: string;
}

export interface ArmRest {
  start: number;
  end: number;
  reason: string;
}

/** History up to the newest message. Rows later than the shown time must not be shown. */
export interface CellHistory {
  signals: SignalHistory;
  segments: TaskSegments;
  moves: Moves;
  refused: Pick<RefusedMoves, "at">;
  encounters: Pick<Encounters, "list">;
  events: readonly RunEvent[];
  faults: readonly Fault[];
  transfers: readonly Transfer[];
  states: readonly TimedTasks[];
  samples: TimedPhases;
  /** Time spans in which the arm is at rest, with the reason in words. */
  rests: () => Iterable<ArmRest>;
}

export interface Answer {
  error: string | null;
  [field: string]: unknown;
}

export type OpenLine = (source: CodeLine) => void;

export interface Cell {
  scene: ReadonlySignal<CellScene | undefined>;
  applicationName: ReadonlySignal<string | undefined>;
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
  joints: ReadonlySignal<readonly JointValue[]>;
  frames: ReadonlySignal<readonly CellPoint[]>;
  tools: ReadonlySignal<readonly CellPoint[]>;
  /** Places of the parts that grippers can carry. */
  parts: ReadonlySignal<readonly wire.PartPlace[]>;
  sample: ReadonlySignal<ArmSample | undefined>;
  /** Name of the last move's tool. */
  toolName: ReadonlySignal<string | null | undefined>;
  /** Tool with which the operator jogs, teaches and checks the reach. */
  chosenTool: Signal<ChosenTool>;
  /** Position to which *Go to* moves the arm, which the picture shows. */
  armGoal: Signal<ArmGoal | undefined>;
  /** Reach of the chosen tool; `undefined` without one. */
  chosenReach: Signal<ToolReach | undefined>;
  /** Points and joint positions that the chosen tool, otherwise the last move's tool, cannot reach. */
  unreachable: ReadonlySignal<ToolReach>;
  history: CellHistory;
  isPaused: ReadonlySignal<boolean>;
  hasEnded: ReadonlySignal<boolean>;
  /** Reason why the arm and its switches cannot be operated after the end of the run. */
  armEnded: ReadonlySignal<string | undefined>;
  /** Whether Run starts the application again after its end. */
  canRestart: ReadonlySignal<boolean>;
  /** Reason why nothing can be operated now. */
  blocked: ReadonlySignal<string | undefined>;
  /** Whether nothing but the shown past prevents operating. */
  isPastOnly: ReadonlySignal<boolean>;
  showPresent: () => void;
  /** Names of points, joint positions, frames and tools that were changed by hand and not saved. */
  unsaved: ReadonlySignal<ReadonlySet<string>>;
  /** Value whose last change can be undone. */
  undo: ReadonlySignal<PointName | undefined>;
  selectedPoint: ReadonlySignal<PointName | undefined>;
  selectPoint: (point: PointName | undefined) => void;
  /** Opens a line in the editor, if there is one. */
  openLine: ReadonlySignal<OpenLine | undefined>;
  /** Programs with their code; none in an editor, which shows the code itself. */
  code: ProgramView;
  /** Line of the present move. */
  moving: ReadonlySignal<MovingLine | undefined>;
  /** Shows a line on the tab Program. */
  showLine: (line: NamedLine) => void;
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
