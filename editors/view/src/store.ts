// State of the run in the page, and the shown time.

import { computed, type ReadonlySignal, signal } from "@preact/signals";
import { MOST_MESSAGES, MOST_SAMPLES, since } from "./bounds";
import { showPanels } from "./layout/layout";
import type { PointName } from "./panels/points/edits";
import type { Answer, ArmRest, OpenLine } from "./panels/shared/cell";
import { PanelModel } from "./panels/shared/PanelModel";
import { CELL_TABS, showTab } from "./panels/shared/tabChoice";
import type { TimedPhase } from "./panels/tasks/times";
import type { AnswerMessage, Message, RunMessage, Scene, Source, Tool } from "./protocol";
import { type Sample, Samples } from "./samples";
import { shared } from "./sharing";
import type { MotionMessage } from "./wire";

/** Selected object, which the drawing and the panels highlight. */
export type Selection = { kind: "point"; point: PointName } | { kind: "frame" | "tool"; name: string };

/** Reason why nothing can be operated before the page has reached the present. */
const READING = "The past of the run is being read. Wait until the present is shown.";

export type Send = (command: object) => void;

export class Store {
  readonly scene = signal<Scene | undefined>(undefined);
  readonly newest = signal(0);
  /** Oldest time with data: the start of the run, unless the run is long. */
  readonly oldest = signal(0);
  /** Time that the user has chosen; `undefined` for the newest time. */
  readonly chosen = signal<number | undefined>(undefined);
  readonly time: ReadonlySignal<number> = computed(() => this.chosen.value ?? this.newest.value);
  readonly isPaused = signal(false);
  /** Whether a debugger has stopped the run. */
  readonly isStopped = signal(false);
  /** Whether the server has been silent for so long that it may hang. */
  readonly isSilent = signal(false);
  readonly speed = signal<number | "max">(1);
  readonly end = signal<string | undefined>(undefined);
  /** Number of messages of the past, and the messages read since, until a page that was opened late has reached the present. */
  readonly past = signal<{ count: number; read: number } | undefined>(undefined);
  /** Read part of the past in %. */
  readonly readPast: ReadonlySignal<number | undefined> = computed(() => {
    const past = this.past.value;
    return past && Math.min(99, Math.floor((past.read / past.count) * 100));
  });
  /** Sentence about a lost connection. */
  readonly lost = signal<string | undefined>(undefined);
  readonly selection = signal<Selection | undefined>(undefined);
  readonly samples = new Samples();
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
  readonly panels: PanelModel;
  readonly blocked: ReadonlySignal<string | undefined> = computed(() => this.reason());
  send: Send = () => undefined;
  /** Opens a line in the editor, if there is one. */
  readonly openLine = signal<OpenLine | undefined>(undefined);
  /** Starts the shown application with or without the debugger, in an editor. */
  readonly launch = signal<((noDebug: boolean) => void) | undefined>(undefined);
  private readonly waiting = new Map<number, (answer: Answer) => void>();
  private nextId = 1;
  private readonly log: RunMessage[] = [];
  private lastMotion: MotionMessage | undefined;

  constructor() {
    this.panels = new PanelModel({
      time: this.time, newest: this.newest, oldest: this.oldest, isPaused: this.isPaused, blocked: this.blocked,
      hasEnded: computed(() => this.end.value !== undefined),
      canRestart: computed(() => this.scene.value?.role === "operator"),
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
      selectedPoint: computed(() => (this.selection.value?.kind === "point" ? this.selection.value.point : undefined)),
      selectPoint: (point) => (this.selection.value = point && { kind: "point", point: { name: point.name, key: point.key } }),
      openLine: this.openLine,
      send: (command, args) => this.command(command, args),
    });
  }

  /** Processes a message. Messages of the run are stored, so that a step back can repeat them. */
  take(received: Message): void {
    const message: Message = received.kind === "motion" ? { ...received, ...shared(received, this.lastMotion) } : received;
    if (message.kind === "motion") {
      this.lastMotion = message;
    }
    if (message.kind === "answer") {
      this.answer(message);
    } else if (message.kind === "rewind") {
      this.rewind(message.t);
    } else if (message.kind === "select") {
      this.select(message.name);
    } else if (message.kind === "past") {
      this.past.value = message.messages === 0 ? undefined : { count: message.messages, read: 0 };
    } else {
      this.countPast();
      if (message.kind === "scene") {
        this.log.length = 0;
      }
      this.log.push(message);
      this.apply(message);
      if (this.log.length > MOST_MESSAGES) {
        const middle = this.log.slice(this.log.length >> 1).find((kept) => "t" in kept);
        this.forgetBefore(middle !== undefined && "t" in middle ? middle.t : this.newest.peek());
      }
    }
  }

  takeSamples(bytes: ArrayBuffer | Uint8Array): void {
    this.countPast();
    const t = this.samples.add(bytes);
    if (t !== undefined) {
      this.sampleCount.value += 1;
      this.advance(t);
      if (this.samples.count > MOST_SAMPLES) {
        this.forgetBefore(this.samples.middle());
      }
    }
  }

  /** Discards the state before a time. */
  forgetBefore(t: number): void {
    this.samples.drop(t);
    this.sampleCount.value += 1;
    this.repeat(since(this.log, t));
    this.oldest.value = t;
    if ((this.chosen.peek() ?? t) < t) {
      this.chosen.value = t;
    }
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
    this.past.value = undefined;
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
      case "state": this.panels.addState(message); break;
      case "motion": this.panels.addMotion(message); break;
      case "io": this.panels.addIo(message); break;
      case "page": this.panels.addPage(message); break;
      case "events":
        this.panels.addEvents(message);
        // Nothing else may change after the last event, such as the fault that has stopped all tasks.
        this.advance(message.events.at(-1)?.t ?? 0);
        break;
      case "parts": this.panels.addParts(message); break;
      case "data": this.panels.addData(message); break;
      case "reach": this.panels.addReach(message); break;
      case "unsaved": this.panels.addUnsaved(message); break;
      case "end": this.end.value = message.reason; break;
      case "clock":
        this.speed.value = message.speed;
        this.isPaused.value = message.isPaused;
        this.isStopped.value = message.isStopped;
        break;
      case "gap": break;
    }
  }

  private begin(scene: Scene): void {
    this.samples.clear();
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

  /** Discards everything after `t`, because a debugger has gone back. */
  private rewind(t: number): void {
    const upTo = (message: RunMessage): RunMessage => (message.kind === "events" ? { ...message, events: message.events.filter((event) => event.t <= t) } : message);
    this.samples.cut(t);
    this.sampleCount.value += 1;
    this.end.value = undefined;
    this.repeat(this.log.filter((message) => !("t" in message) || message.t <= t).map(upTo));
    this.newest.value = t;
    this.chosen.value = undefined;
  }

  /** Replaces the stored messages of a run, and processes them again. */
  private repeat(messages: readonly RunMessage[]): void {
    this.log.length = 0;
    this.panels.clear();
    for (const message of messages) {
      this.log.push(message);
      if (message.kind !== "scene") {
        this.apply(message);
      }
    }
  }

  private countPast(): void {
    const past = this.past.peek();
    if (past !== undefined) {
      this.past.value = { ...past, read: past.read + 1 };
    }
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
    switch (this.scene.value?.role) {
      case "recording": return "This is a recording. Nothing can be operated.";
      case "guest": return "You are a guest. You can look but not operate.";
      case undefined: return this.openLine.value === undefined ? "The run has not begun." : "No application is shown.";
      case "preview": return "The application does not run.";
      default:
        return this.lost.value ?? (this.past.value === undefined ? undefined : READING) ?? (this.chosen.value === undefined ? undefined : "You are looking at the past. Return to the present to operate.");
    }
  }
}
