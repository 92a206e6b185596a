// State of the cell for the panels, from the messages of a run and the shown time.

import { computed, type ReadonlySignal, signal } from "@preact/signals";
import type { SignalState } from "../io/signalRows";
import { type PointName, pointText } from "../points/edits";
import type { MovingLine } from "../program/marks";
import type { CodeLine } from "../program/programs";
import { ProgramView } from "../program/ProgramView";
import { DataValues } from "../points/pointsAt";
import { reasonsOf, type ToolReach } from "../points/reachQuery";
import type { TimedPhases } from "../tasks/times";
import type { Answer, ArmRest, ArmSample, Cell, CellHistory, CellMotion, CellPoint, CellScene, JointValue, OpenLine, QueuedMove } from "./cell";
import { PanelHistory } from "./history";
import type { DataMessage, EventsMessage, IoMessage, MotionMessage, PageMessage, PartsMessage, ProgramsMessage, QueueEntry, ReachMessage, SceneMessage, StateMessage, UnsavedMessage } from "./messages";
import { throttled } from "./throttled";
import { latest, TimedLevels } from "./timed";

/** Parts of the page on which the panels depend. */
export interface Surroundings {
  time: ReadonlySignal<number>;
  /** Time of the newest message. */
  newest: ReadonlySignal<number>;
  /** Oldest time with data. */
  oldest: ReadonlySignal<number>;
  isPaused: ReadonlySignal<boolean>;
  hasEnded: ReadonlySignal<boolean>;
  armEnded: ReadonlySignal<string | undefined>;
  isPastOnly: ReadonlySignal<boolean>;
  showPresent: () => void;
  /** Whether Run starts the application again after its end. */
  canRestart: ReadonlySignal<boolean>;
  /** Reason why nothing can be operated now. */
  blocked: ReadonlySignal<string | undefined>;
  sample: ReadonlySignal<ArmSample | undefined>;
  samples: TimedPhases;
  rests: () => Iterable<ArmRest>;
  applicationName: ReadonlySignal<string | undefined>;
  /** Returns the line of a source. */
  sourceOf: (index: number) => CodeLine | undefined;
  /** Line of the move that the arm executes. */
  executed: ReadonlySignal<MovingLine | undefined>;
  /** Shows the tab Program. */
  showPrograms: () => void;
  /** Returns the name of a tool. */
  toolOf: (index: number) => string | undefined;
  seek: (t: number) => void;
  selectedPoint: ReadonlySignal<PointName | undefined>;
  selectPoint: (point: PointName | undefined) => void;
  openLine: ReadonlySignal<OpenLine | undefined>;
  send: (command: string, args: object) => Promise<Answer>;
}

/** Interval between updates of tables, in ms. */
const SLOW = 200;

export class PanelModel {
  readonly cell: Cell;
  private readonly past = new PanelHistory();
  private readonly states: StateMessage[] = [];
  private readonly motions: MotionMessage[] = [];
  private readonly pages: PageMessage[] = [];
  private readonly placed: PartsMessage[] = [];
  private readonly reaches: ReachMessage[] = [];
  private readonly levels = new TimedLevels<SignalState>();
  private readonly points = new DataValues<CellPoint>(({ points }) => points);
  private readonly joints = new DataValues<JointValue>(({ joints }) => joints ?? []);
  private readonly frames = new DataValues<CellPoint>(({ frames }) => frames ?? []);
  private readonly tools = new DataValues<CellPoint>(({ tools }) => tools ?? []);
  private readonly code = new ProgramView();
  private readonly undo = signal<PointName | undefined>(undefined);
  private readonly scene = signal<CellScene | undefined>(undefined);
  private readonly unsaved = signal<ReadonlySet<string>>(new Set());
  private readonly chosenRange = signal<readonly [number, number] | undefined>(undefined);
  /** Number of messages by kind, so that only their readers are drawn again. */
  private readonly counts = { state: signal(0), motion: signal(0), page: signal(0), parts: signal(0), reach: signal(0), io: signal(0), data: signal(0) };

  constructor(private readonly surroundings: Surroundings) {
    this.cell = this.build(surroundings);
  }

  /** Begins a new run: all previous messages are discarded. */
  addScene(scene: SceneMessage): void {
    this.scene.value = scene;
    this.clear();
    this.code.clear();
    this.cell.chosenReach.value = undefined;
    this.unsaved.value = new Set();
    this.undo.value = undefined;
    this.chosenRange.value = undefined;
  }

  /** Discards messages, but not the scene. Remaining messages are added again afterwards. */
  clear(): void {
    this.past.clear();
    this.states.length = 0;
    this.motions.length = 0;
    this.pages.length = 0;
    this.placed.length = 0;
    this.reaches.length = 0;
    this.levels.clear();
    const scene = this.scene.peek();
    this.points.restart(scene?.points ?? []);
    this.joints.restart(scene?.joints ?? []);
    this.frames.restart(scene?.frames ?? []);
    this.tools.restart(scene?.tools ?? []);
    Object.values(this.counts).forEach((count) => (count.value += 1));
  }

  addPrograms(message: ProgramsMessage): void {
    this.code.add(message);
  }

  addState(message: StateMessage): void {
    this.states.push(message);
    this.past.addState(message);
    this.counts.state.value += 1;
  }

  addMotion(message: MotionMessage): void {
    this.motions.push(message);
    this.past.addMotion(message);
    this.counts.motion.value += 1;
  }

  addIo(message: IoMessage): void {
    this.past.addIo(message);
    message.changes.forEach(({ link, ...state }) => this.levels.add(message.t, link, state));
    this.counts.io.value += 1;
  }

  addPage(message: PageMessage): void {
    this.pages.push(message);
    this.counts.page.value += 1;
  }

  addParts(message: PartsMessage): void {
    this.placed.push(message);
    this.counts.parts.value += 1;
  }

  addReach(message: ReachMessage): void {
    this.reaches.push(message);
    this.counts.reach.value += 1;
  }

  addEvents({ events }: EventsMessage): void {
    this.past.addEvents(events);
  }

  addData(message: DataMessage): void {
    [this.points, this.joints, this.frames, this.tools].forEach((values) => values.add(message));
    this.counts.data.value += 1;
  }

  addUnsaved({ points, undo }: UnsavedMessage): void {
    this.undo.value = undo ?? undefined;
    this.unsaved.value = new Set(points.map(pointText));
  }

  private build(around: Surroundings): Cell {
    const { time, newest, oldest } = around;
    const { state, motion, page, parts, reach, io, data } = this.counts;
    const after = <Value>(count: ReadonlySignal<number>, at: (t: number) => Value): ReadonlySignal<Value> => computed(() => {
      count.valueOf();
      return at(time.value);
    });
    const shownMotion = after(motion, (t) => latest(this.motions, t));
    const chosenReach = signal<ToolReach | undefined>(undefined);
    const shownReach = after(reach, (t) => latest(this.reaches, t));
    const reached = computed(() => this.asReach(shownReach.value));
    const slowTime = throttled(time, SLOW);
    const whole = computed((): readonly [number, number] => [oldest.value, Math.max(newest.value, oldest.value + 0.05)]);
    const slowWhole = throttled(whole, SLOW);
    const levels = computed(() => {
      io.valueOf();
      return this.levels.at(slowTime.value);
    });
    const { signals, segments, moves, refused, encounters, events, faults, transfers, states } = this.past;
    const shownQueue = computed(() => this.asMotion(shownMotion.value));
    const history: CellHistory = { signals, segments, moves, refused, encounters, events, faults, transfers, states, samples: around.samples, rests: around.rests };
    return {
      ...around,
      scene: this.scene,
      slowTime,
      whole: slowWhole,
      range: computed(() => this.chosenRange.value ?? slowWhole.value),
      setRange: (start, end) => {
        const [first, last] = whole.peek();
        this.chosenRange.value = start <= first && end >= last ? undefined : [start, end];
      },
      state: after(state, (t) => latest(this.states, t)),
      motion: shownQueue,
      page: after(page, (t) => latest(this.pages, t)),
      parts: after(parts, (t) => latest(this.placed, t)?.parts ?? []),
      levels,
      points: after(data, (t) => this.points.at(t)),
      joints: after(data, (t) => this.joints.at(t)),
      frames: after(data, (t) => this.frames.at(t)),
      tools: after(data, (t) => this.tools.at(t)),
      toolName: computed(() => around.sample.value?.toolName),
      chosenTool: signal(undefined),
      armGoal: signal(undefined),
      chosenReach,
      unreachable: computed(() => chosenReach.value ?? reached.value),
      history,
      unsaved: this.unsaved,
      undo: this.undo,
      code: this.code,
      moving: computed(() => around.executed.value ?? restingLine(shownQueue.value)),
      showLine: (line) => {
        this.code.showLine(line);
        around.showPrograms();
      },
    };
  }

  private asReach(message: ReachMessage | undefined): ToolReach {
    return { tool: message && this.surroundings.toolOf(message.tool), reasons: reasonsOf(message?.unreachable) };
  }

  private asMotion(message: MotionMessage | undefined): CellMotion {
    const move = ({ source, ...entry }: QueueEntry): QueuedMove => {
      const { program = "", line = 0, file = "" } = this.surroundings.sourceOf(source) ?? {};
      return { ...entry, program, line, file };
    };
    return { queue: message?.queue.map(move) ?? [], path: message?.path ?? [] };
  }
}

/** Returns the line of the first recorded move, in which an arm at rest waits. */
function restingLine({ queue: [move] }: CellMotion): MovingLine | undefined {
  return move && { program: move.program, line: move.line, file: move.file, instruction: move.type ?? "", isWaiting: true };
}
