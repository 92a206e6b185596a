// Held jog button: an immediate step, and further steps while the button is held and the arm follows.

import type { Cell, Notice } from "../shared/cell";
import { type JogTarget, mayContinue, REPEAT } from "./jogSteps";

export type Step = (joints: readonly number[]) => JogTarget;

export class Holder {
  private timer: ReturnType<typeof setInterval> | undefined;
  private start: readonly number[] = [];
  private target: readonly number[] | undefined;

  constructor(private readonly cell: Cell, private readonly notice: Notice) {}

  /** Executes one step from the present position. */
  once(step: Step): void {
    this.target = undefined;
    this.advance(step);
  }

  hold(step: Step): void {
    this.release();
    this.once(step);
    this.timer = setInterval(() => this.advance(step), REPEAT);
  }

  release(): void {
    clearInterval(this.timer);
    this.timer = undefined;
  }

  private advance(step: Step): void {
    const present = this.cell.sample.peek()?.joints;
    if (present === undefined) {
      return;
    }
    const from = this.target ?? present;
    if (this.target !== undefined && !mayContinue(present, this.target, this.start)) {
      return;
    }
    const result = step(from);
    if ("refusal" in result) {
      // An arrival after a step needs no message; a target that was already reached before the first step does.
      if (result.isArrival !== true || this.target === undefined) {
        this.notice.text.value = result.refusal;
      }
      this.release();
      return;
    }
    this.start = from;
    this.target = result.joints;
    void this.notice.operate(this.cell, { jog: result.joints }).then((answer) => {
      if (answer === undefined) {
        this.release();
      }
    });
  }
}
