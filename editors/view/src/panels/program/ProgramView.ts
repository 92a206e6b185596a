// State of the tab Program: the programs, and the shown program and line.

import { computed, type ReadonlySignal, signal } from "@preact/signals";
import type * as wire from "../../wire";
import type { TaskState } from "../tasks/chart";
import { type CodeLine, type NamedLine, type Program, type ProgramList, programOf, programsOf } from "./programs";

/** Followed object: the arm, or a task by name. Without a name, the task with the highest priority is followed. */
export type Followed = "arm" | { task: string | undefined };

/** Program that the user has chosen. */
export interface ChosenLine extends CodeLine {
  /** Whether the user has opened the line, and not the whole program. */
  isMarked: boolean;
}

export class ProgramView {
  private readonly messages = signal<readonly wire.ProgramsMessage[]>([]);
  private readonly choice = signal<ChosenLine | undefined>(undefined);
  private readonly target = signal<Followed>({ task: undefined });
  /** Programs at the shown time. */
  readonly programs: ReadonlySignal<ProgramList>;
  /** Chosen line; `undefined` while the tab follows the execution. */
  readonly chosen: ReadonlySignal<ChosenLine | undefined> = this.choice;
  readonly followed: ReadonlySignal<Followed> = this.target;

  /** `time` is the shown time in s. */
  constructor(time: ReadonlySignal<number>) {
    const passed = computed(() => this.messages.value.filter(({ t }) => t <= time.value).length);
    this.programs = computed(() => programsOf(this.messages.value, passed.value));
  }

  /** Adds code that was loaded after all previous code. */
  add(message: wire.ProgramsMessage): void {
    this.messages.value = [...this.messages.peek(), message];
  }

  /** Begins a new run. */
  clear(): void {
    this.messages.value = [];
    this.choice.value = undefined;
  }

  programOf(line: NamedLine): Program | undefined {
    return programOf(this.programs.value, line);
  }

  /** Shows a line of a program. */
  showLine(line: NamedLine): void {
    const program = this.programOf(line);
    if (program !== undefined) {
      this.choice.value = { program: program.name, file: program.file, line: line.line, isMarked: true };
    }
  }

  /** Shows a program from its first line on. */
  showProgram({ name, file, line }: Program): void {
    this.choice.value = { program: name, file, line, isMarked: false };
  }

  /** Ends following, and keeps the shown line. */
  stay(shown: CodeLine): void {
    this.choice.value = { program: shown.program, file: shown.file, line: shown.line, isMarked: false };
  }

  follow(followed: Followed = this.target.peek()): void {
    this.target.value = followed;
    this.choice.value = undefined;
  }
}

/** Returns the followed task. If the chosen task does not exist, this is the first task with the highest priority. */
export function followedTask(followed: Followed, tasks: readonly TaskState[]): TaskState | undefined {
  if (followed === "arm") {
    return undefined;
  }
  const highest = Math.max(...tasks.map(priorityOf));
  return tasks.find(({ name }) => name === followed.task) ?? tasks.find((task) => priorityOf(task) === highest);
}

/** Synchronous tasks have no priority. */
function priorityOf({ priority }: TaskState): number {
  return priority ?? 0;
}

/** Returns the line of what the tab follows; `undefined` without tasks, and while the arm executes no move. */
export function followedLine(followed: Followed, tasks: readonly TaskState[], moving: CodeLine | undefined): CodeLine | undefined {
  return followed === "arm" ? moving : followedTask(followed, tasks);
}
