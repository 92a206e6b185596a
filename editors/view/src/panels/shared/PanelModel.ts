// State of the cell for the panels, from the messages of a run and the shown time.

import { computed, type ReadonlySignal, signal } from "@preact/signals";
import { type PointName, pointText } from "../points/edits";
import type { MovingLine } from "../program/marks";
import type { CodeLine } from "../program/programs";
import { ProgramView } from "../program/ProgramView";
import { reasonsOf, type ToolReach } from "../points/reachQuery";
import type { TimedPhases } from "../tasks/times";
import type { Answer, ArmRest, ArmSample, Cell, CellHistory, CellMotion, CellScene, OpenLine, QueuedMove } from "./cell";
import type { PanelHistory } from "./history";
import type { MotionMessage, ProgramsMessage, QueueEntry, ReachMessage, SceneMessage, UnsavedMessage } from "./messages";
import { type IndexedMessage, PanelData } from "./PanelData";
import { throttled } from "./throttled";
import { latest } from "./timed";

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
  private data = new PanelData(undefined);
  private readonly code: ProgramView;
  private readonly undo = signal<PointName | undefined>(undefined);
  private readonly scene = signal<CellScene | undefined>(undefined);
  private readonly unsaved = signal<ReadonlySet<string>>(new Set());
  private readonly chosenRange = signal<readonly [number, number] | undefined>(undefined);
  /** Number of messages by kind, so that only their readers are drawn again. */
  private readonly counts = { state: signal(0), motion: signal(0), page: signal(0), parts: signal(0), reach: signal(0), io: signal(0), data: signal(0) };

  constructor(private readonly surroundings: Surroundings) {
    this.code = new ProgramView(surroundings.time);
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
    this.use(this.fresh());
  }

  /** Returns an empty index of messages for the present scene. */
  fresh(): PanelData {
    return new PanelData(this.scene.peek());
  }

  /** Shows the messages in another index. */
  use(data: PanelData): void {
    this.data = data;
    Object.values(this.counts).forEach((count) => (count.value += 1));
  }

  addPrograms(message: ProgramsMessage): void {
    this.code.add(message);
  }

  add(message: IndexedMessage): void {
    this.data.add(message);
    if (message.kind !== "events") {
      this.counts[message.kind].value += 1;
    }
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
    const shownMotion = after(motion, (t) => latest(this.data.motions, t));
    const chosenReach = signal<ToolReach | undefined>(undefined);
    const shownReach = after(reach, (t) => latest(this.data.reaches, t));
    const reached = computed(() => this.asReach(shownReach.value));
    const slowTime = throttled(time, SLOW);
    const whole = computed((): readonly [number, number] => [oldest.value, Math.max(newest.value, oldest.value + 0.05)]);
    const slowWhole = throttled(whole, SLOW);
    const levels = computed(() => {
      io.valueOf();
      return this.data.levels.at(slowTime.value);
    });
    const shownQueue = computed(() => this.asMotion(shownMotion.value));
    const history = this.history(around);
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
      state: after(state, (t) => latest(this.data.states, t)),
      motion: shownQueue,
      page: after(page, (t) => latest(this.data.pages, t)),
      parts: after(parts, (t) => latest(this.data.placed, t)?.parts ?? []),
      levels,
      points: after(data, (t) => this.data.points.at(t)),
      joints: after(data, (t) => this.data.joints.at(t)),
      frames: after(data, (t) => this.data.frames.at(t)),
      tools: after(data, (t) => this.data.tools.at(t)),
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

  /** Returns the present history, also after another index is used. */
  private history({ samples, rests }: Surroundings): CellHistory {
    const past = (): PanelHistory => this.data.past;
    return {
      samples, rests,
      get signals() { return past().signals; },
      get segments() { return past().segments; },
      get moves() { return past().moves; },
      get refused() { return past().refused; },
      get encounters() { return past().encounters; },
      get events() { return past().events; },
      get faults() { return past().faults; },
      get transfers() { return past().transfers; },
      get states() { return past().states; },
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
