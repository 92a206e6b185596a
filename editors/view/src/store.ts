// State of the run in the page, and the shown time.

import { computed, type ReadonlySignal, signal } from "@preact/signals";
import { showPanels } from "./layout/layout";
import { armEndReason } from "./panels/pendant/robotState";
import type { PointName } from "./panels/points/edits";
import type { Answer, ArmRest, OpenLine } from "./panels/shared/cell";
import { PanelModel } from "./panels/shared/PanelModel";
import type { IndexedMessage, PanelData } from "./panels/shared/PanelData";
import { CELL_TABS, showTab } from "./panels/shared/tabChoice";
import type { TimedPhase } from "./panels/tasks/times";
import { Past } from "./past";
import type { AnswerMessage, Message, RunMessage, Scene, Source, Tool } from "./protocol";
import { RunLog } from "./runLog";
import type { Sample, Samples } from "./samples";

/** Selected object, which the drawing and the panels highlight. */
export type Selection = { kind: "point"; point: PointName } | { kind: "frame" | "tool"; name: string };

export type Send = (command: object) => void;

const INDEXED: readonly string[] = ["state", "motion", "io", "page", "events", "parts", "data", "reach"];

/** Adds a message to an index, unless the panels need no history of such messages. */
function addIndexed(data: PanelData, message: RunMessage | undefined): void {
  if (message !== undefined && INDEXED.includes(message.kind)) {
    data.add(message as IndexedMessage);
  }
}

export class Store {
  readonly scene = signal<Scene | undefined>(undefined);
  readonly newest = signal(0);
  /** Oldest time with data: the start of the run, unless the run is long, or the page was opened late. */
  readonly oldest = signal(0);
  /** Time that the user has chosen; `undefined` for the newest time. */
  readonly chosen = signal<number | undefined>(undefined);
  /** Shown time: while the chosen time has no data yet, the oldest time with data. */
  readonly time: ReadonlySignal<number> = computed(() => (this.awaited.value === undefined ? (this.chosen.value ?? this.newest.value) : this.oldest.value));
  readonly isPaused = signal(false);
  /** Whether a debugger has stopped the run. */
  readonly isStopped = signal(false);
  /** Whether the server has been silent for so long that it may hang. */
  readonly isSilent = signal(false);
  readonly speed = signal<number | "max">(1);
  readonly end = signal<string | undefined>(undefined);
  /** Past of a run that is received after its present. */
  readonly past: Past = new Past({ insert: (parts) => this.insert(parts), chosen: this.chosen, oldest: this.oldest, end: () => this.showAtLeast(this.oldest.peek()) });
  /** Oldest time that has or will have data. */
  readonly earliest: ReadonlySignal<number> = computed(() => Math.min(this.past.from.value ?? Infinity, this.oldest.value));
  /** Chosen time, if it has no data yet. */
  readonly awaited: ReadonlySignal<number | undefined> = computed(() => {
    const chosen = this.chosen.value ?? Infinity;
    return this.past.from.value !== undefined && chosen < this.oldest.value ? chosen : undefined;
  });
  /** Sentence about a lost connection. */
  readonly lost = signal<string | undefined>(undefined);
  readonly selection = signal<Selection | undefined>(undefined);
  private readonly log = new RunLog();
  readonly samples: Samples = this.log.samples;
  /** Changes with each batch of samples. */
  readonly sampleCount = signal(0);
  /** Sample at the shown time. */
  readonly shown: ReadonlySignal<Sample | undefined> = computed(() => {
    this.sampleCount.valueOf();
    return this.samples.at(this.time.value);
  });
  readonly tools = new Map<number, Tool>();
  readonly sources = new Map<number, Source>();
  /** Line of the move that the arm executes at the shown time. */
  private readonly sourceOfSample = computed(() => {
    const source = this.shown.value?.source;
    return source === undefined ? undefined : this.sources.get(source);
  });
  /** Whether Run starts the application again after its end. */
  private readonly canRestart: ReadonlySignal<boolean> = computed(() => this.scene.value?.role === "operator");
  readonly panels: PanelModel;
  readonly blocked: ReadonlySignal<string | undefined> = computed(() => this.reason());
  send: Send = () => undefined;
  /** Opens a line in the editor, if there is one. */
  readonly openLine = signal<OpenLine | undefined>(undefined);
  /** Starts the shown application with or without the debugger, in an editor. */
  readonly launch = signal<((noDebug: boolean) => void) | undefined>(undefined);
  /** Changes when messages were processed again, so that an older indexing of them ends. */
  private indexing = 0;
  private readonly waiting = new Map<number, (answer: Answer) => void>();
  private nextId = 1;

  constructor() {
    this.panels = new PanelModel({
      time: this.time, newest: this.newest, oldest: this.earliest, isPaused: this.isPaused, blocked: this.blocked,
      hasEnded: computed(() => this.end.value !== undefined),
      armEnded: computed(() => armEndReason(this.end.value, this.canRestart.value)),
      canRestart: this.canRestart,
      sample: computed(() => {
        const sample = this.shown.value;
        return sample && { joints: sample.joints, tool: this.tools.get(sample.tool)?.pose ?? [], toolName: this.tools.get(sample.tool)?.name };
      }),
      samples: { after: (t) => this.phases(t), epoch: () => this.samples.epoch },
      rests: () => this.rests(),
      applicationName: computed(() => this.scene.value?.application),
      sourceOf: (index) => this.sources.get(index),
      executed: computed(() => {
        const source = this.sourceOfSample.value;
        return source && { program: source.program, line: source.line, file: source.file, instruction: source.instruction, isWaiting: false };
      }),
      showPrograms: () => {
        showPanels(this.scene.peek()?.role === "recording", true);
        showTab(CELL_TABS, "program");
      },
      toolOf: (index) => this.tools.get(index)?.name ?? undefined,
      seek: (t) => (this.chosen.value = t),
      isPastOnly: computed(() => this.chosen.value !== undefined && this.reasonNow() === undefined),
      showPresent: () => (this.chosen.value = undefined),
      selectedPoint: computed(() => (this.selection.value?.kind === "point" ? this.selection.value.point : undefined)),
      selectPoint: (point) => (this.selection.value = point && { kind: "point", point: { name: point.name, key: point.key } }),
      openLine: this.openLine,
      send: (command, args) => this.command(command, args),
    });
  }

  /** Processes a message. Messages of the run are stored, so that a step back can repeat them. */
  take(message: Message): void {
    switch (message.kind) {
      case "answer": this.answer(message); break;
      case "rewind": this.rewind(message.t); break;
      case "select": this.select(message.name); break;
      case "past": this.past.announce(message); break;
      // These messages hold for all times, also for messages that are read later.
      case "scene": case "programs": case "source": case "tool": this.apply(message); break;
      default:
        this.apply(this.log.add(message));
        this.bound();
    }
  }

  /** Processes a binary message: samples, or a part of the run. */
  takeBytes(bytes: Uint8Array): void {
    if (!this.past.take(bytes)) {
      this.takeSamples(bytes);
    }
  }

  takeSamples(bytes: ArrayBuffer | Uint8Array): void {
    const t = this.samples.add(bytes);
    if (t !== undefined) {
      this.sampleCount.value += 1;
      this.advance(t);
      this.bound();
    }
  }

  /** Discards the older half of a run that is too long. */
  private bound(): void {
    const t = this.log.surplus();
    if (t !== undefined) {
      this.forgetBefore(Math.min(t, this.newest.peek()));
    }
  }

  /** Discards the state before a time. */
  private forgetBefore(t: number): void {
    this.log.dropBefore(t);
    this.repeat();
    this.past.stop();
    this.showAtLeast(t);
  }

  /** Sends a command and waits for its response. */
  command(command: string, args: object): Promise<Answer> {
    const id = this.nextId;
    this.nextId += 1;
    return new Promise((resolve) => {
      this.waiting.set(id, resolve);
      this.send({ ...args, id, command });
    });
  }

  /** Handles a lost connection: all pending commands fail. */
  lose(reason: string): void {
    this.past.stop();
    this.lost.value = reason;
    this.waiting.forEach((resolve) => resolve({ error: reason }));
    this.waiting.clear();
  }

  private apply(message: RunMessage): void {
    if ("t" in message) {
      this.advance(message.t);
    }
    switch (message.kind) {
      case "scene": this.begin(message); break;
      case "programs": this.panels.addPrograms(message); break;
      case "source": this.sources.set(message.index, message); break;
      case "tool": this.tools.set(message.index, message); break;
      case "state": case "motion": case "io": case "page": case "parts": case "data": case "reach": this.panels.add(message); break;
      case "events":
        this.panels.add(message);
        // Nothing else may change after the last event, such as the fault that has stopped all tasks.
        this.advance(message.events.at(-1)?.t ?? 0);
        break;
      case "unsaved": this.panels.addUnsaved(message); break;
      case "end": this.end.value = message.reason; break;
      case "clock":
        this.speed.value = message.speed;
        this.isPaused.value = message.isPaused;
        this.isStopped.value = message.isStopped;
        break;
    }
  }

  private begin(scene: Scene): void {
    this.indexing += 1;
    this.past.restart();
    this.log.clear();
    this.sampleCount.value += 1;
    this.tools.clear();
    this.sources.clear();
    this.newest.value = 0;
    this.oldest.value = 0;
    this.chosen.value = undefined;
    this.end.value = undefined;
    this.lost.value = undefined;
    this.scene.value = scene;
    this.panels.addScene(scene);
  }

  /**
   * Inserts parts of the run before all messages, in many small steps. Returns false if there is no room for all of them.
   * The panels show the previous messages until all messages are indexed. The first part is shown immediately.
   */
  private *insert(parts: readonly RunLog[]): Generator<void, boolean> {
    const isFirst = this.log.messages.length + this.log.state.length === 0;
    const hasRoom = this.log.prepend(parts);
    if (isFirst) {
      this.repeat();
      this.advance(this.samples.end());
      return hasRoom;
    }
    this.sampleCount.value += 1;
    this.indexing += 1;
    const [indexing, data] = [this.indexing, this.panels.fresh()];
    for (const message of this.log.state) {
      addIndexed(data, message);
    }
    // Messages of the present are appended meanwhile.
    for (let index = 0; index < this.log.messages.length; index += 1) {
      addIndexed(data, this.log.messages[index]);
      yield;
      if (indexing !== this.indexing) {
        return hasRoom;
      }
    }
    this.panels.use(data);
    this.oldest.value = this.log.start;
    this.sampleCount.value += 1;
    this.advance(this.samples.end());
    return hasRoom;
  }

  private showAtLeast(t: number): void {
    if ((this.chosen.peek() ?? t) < t) {
      this.chosen.value = t;
    }
  }

  /** Discards everything after `t`, because a debugger has gone back. */
  private rewind(t: number): void {
    this.log.cut(t);
    this.end.value = undefined;
    this.repeat();
    this.newest.value = t;
    this.chosen.value = undefined;
  }

  /** Processes all stored messages again, after they were changed. */
  private repeat(): void {
    this.indexing += 1;
    this.sampleCount.value += 1;
    this.oldest.value = this.log.start;
    this.panels.clear();
    this.log.state.forEach((message) => this.apply(message));
    this.log.messages.forEach((message) => this.apply(message));
  }

  private advance(t: number): void {
    this.newest.value = Math.max(this.newest.peek(), t);
  }

  private answer({ id, ...answer }: AnswerMessage): void {
    if (id !== null) {
      this.waiting.get(id)?.(answer);
      this.waiting.delete(id);
    }
  }

  private select(name: string | null): void {
    const scene = this.scene.peek();
    const point = scene?.points.find((candidate) => candidate.name === name);
    if (point !== undefined) {
      this.selection.value = { kind: "point", point: { name: point.name, key: point.key } };
    } else if (name !== null && scene?.frames.some((frame) => frame.name === name)) {
      this.selection.value = { kind: "frame", name };
    } else if (name !== null && scene?.tools.some((tool) => tool.name === name)) {
      this.selection.value = { kind: "tool", name };
    }
  }

  private *phases(after: number): Generator<TimedPhase> {
    const phases = this.scene.peek()?.phases ?? [];
    for (const { t, phase, source } of this.samples.after(after)) {
      yield { t, phase: phases[phase] ?? "waiting", source: source === undefined ? undefined : this.sources.get(source) };
    }
  }

  private *rests(): Generator<ArmRest> {
    for (const { start, end, limit } of this.samples.rests()) {
      yield { start, end, reason: this.scene.peek()?.limits[limit] ?? "" };
    }
  }

  private reason(): string | undefined {
    return this.reasonNow() ?? (this.chosen.value === undefined ? undefined : "You are looking at the past. Return to the present to operate.");
  }

  /** Returns the reason why the present cannot be operated. */
  private reasonNow(): string | undefined {
    switch (this.scene.value?.role) {
      case "recording": return "This is a recording. Nothing can be operated.";
      case "guest": return "You are a guest. You can look but not operate.";
      case undefined: return this.openLine.value === undefined ? "The run has not begun." : "No application is shown.";
      case "preview": return "The application does not run.";
      default: return this.lost.value;
    }
  }
}
