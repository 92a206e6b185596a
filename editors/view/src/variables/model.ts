// Variables on the page, and the current edit.

import { signal } from "@preact/signals";
import type { Edits, FromPage, ToPage, Variables } from "./messages";

/** The two tables. */
export type List = "parameters" | "locals";

/** Row of a table. The row after the last one is for a new variable. */
export interface Row {
  list: List;
  index: number;
}

/** Reason why the last edit was rejected. */
export interface Refusal extends Row {
  reason: string;
}

/** Field that gets the focus when the tables are drawn again. */
export interface Focus extends Row {
  field: string;
}

interface Pending {
  row: Row;
  focus: Focus | undefined;
  done: (isDone: boolean) => void;
}

export class VariablesModel {
  readonly variables = signal<Variables | null>(null);
  readonly hasProgram = signal(false);
  readonly refusal = signal<Refusal | undefined>(undefined);
  /** Changes when the fields have to show the variables again. */
  readonly revision = signal(0);
  focus: Focus | undefined;
  private readonly pending = new Map<number, Pending>();
  private last = 0;

  constructor(private readonly post: (message: FromPage) => void) {}

  take(message: ToPage): void {
    if (message.kind === "variables") {
      this.show(message.variables, message.hasProgram);
    } else {
      this.answer(message.id, message.refused);
    }
  }

  /**
   * Requests an edit of a row, and returns whether it was applied. `focus` is the field that gets the focus afterwards.
   */
  edit(row: Row, edits: Edits, focus?: Focus): Promise<boolean> {
    const variables = this.variables.peek();
    if (variables === null) {
      return Promise.resolve(false);
    }
    const { uri, version, program } = variables;
    this.last += 1;
    const id = this.last;
    this.post({ command: "edit", id, uri, version, program, edits });
    return new Promise((done) => this.pending.set(id, { row, focus, done }));
  }

  /** Shows the reason at a row. */
  refuse(row: Row, reason: string): void {
    this.refusal.value = { ...row, reason };
  }

  forgive(): void {
    this.refusal.value = undefined;
  }

  private show(variables: Variables | null, hasProgram: boolean): void {
    const before = this.variables.peek();
    this.hasProgram.value = hasProgram;
    const isSame = JSON.stringify(before) === JSON.stringify(variables);
    if (isSame && this.focus === undefined) {
      return;
    }
    if (before?.uri !== variables?.uri) {
      this.forgive();
    }
    this.variables.value = variables;
    this.revision.value += 1;
  }

  private answer(id: number, refused: string | null): void {
    const pending = this.pending.get(id);
    this.pending.delete(id);
    if (pending === undefined) {
      return;
    }
    this.refusal.value = refused === null ? undefined : { ...pending.row, reason: refused };
    this.focus = refused === null ? pending.focus : undefined;
    pending.done(refused === null);
  }
}
