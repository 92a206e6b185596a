// Start of the application after its end, or after all its tasks have failed.

import { effect } from "@preact/signals";
import type { Cell, Notice } from "../shared/cell";

/** Position of the arm at the start: the present one, or the initial one of the settings. */
export type ArmStart = "stays" | "initial";

/** Ends a run that has not ended, and starts the application again. */
export async function startAgain(cell: Cell, notice: Notice, arm: ArmStart): Promise<void> {
  if (!cell.hasEnded.peek()) {
    if (await notice.operate(cell, { stop: true }) === undefined) {
      return;
    }
    // A paused run ends in its next cycle.
    if (cell.isPaused.peek() && await notice.send(cell, "pace", { isPaused: false }) === undefined) {
      return;
    }
    await ended(cell);
  }
  await notice.send(cell, "run", arm === "initial" ? { atInitialPosition: true } : {});
}

function ended(cell: Cell): Promise<void> {
  return new Promise((resolve) => {
    const stop = effect(() => {
      if (cell.hasEnded.value) {
        queueMicrotask(() => stop());
        resolve();
      }
    });
  });
}
