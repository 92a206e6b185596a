// Switches of the robot: their states, and the reasons why they are disabled.

import type { CellState } from "../shared/cell";

export const MODES = ["manual", "test", "local", "remote"] as const;

/** Monitor speeds that the keys + and - select, in %. */
const SPEEDS = [0, 1, 2, 5, 10, 20, 30, 40, 50, 60, 70, 80, 90, 100] as const;

export function nextSpeed(speed: number, direction: 1 | -1): number {
  const beyond = direction > 0 ? SPEEDS.find((step) => step > speed) : SPEEDS.findLast((step) => step < speed);
  return beyond ?? speed;
}

/** Parses a speed; `undefined` if it is not from 0 to 100. */
export function speedFrom(text: string): number | undefined {
  const speed = Number(text.trim() || NaN);
  return speed >= 0 && speed <= 100 ? speed : undefined;
}

export function stopText(state: CellState | undefined): string {
  switch (state?.emergencyStop) {
    case "open": return "E-stop pressed: the power is off.";
    case "released": return "E-stop released: switch the power on to acknowledge it.";
    default: return "";
  }
}

/** Returns the reason why the power cannot be switched on. */
export function powerReason(state: CellState | undefined): string | undefined {
  return state?.power !== true && state?.emergencyStop === "open" ? "Release the E-stop before you switch the power on." : undefined;
}

/** Returns the reason why nothing of the application can be operated after the end of the run. */
export function endReason(hasEnded: boolean, canRestart: boolean): string | undefined {
  return hasEnded ? `The run has ended.${canRestart ? " Press Run to start the application again." : ""}` : undefined;
}

/** Returns the reason why the arm and its switches cannot be operated after the end of the run; `undefined` before it, and while the server still drives an arm without an application. */
export function armEndReason(end: string | undefined, canRestart: boolean): string | undefined {
  return canRestart && (end === "finished" || end === "stopped") ? undefined : endReason(end !== undefined, canRestart);
}

/** Whether all tasks were stopped by errors. */
export function hasFailed(state: CellState | undefined): boolean {
  return state !== undefined && state.tasks.length > 0 && state.tasks.every(({ error }) => error !== null);
}

/** Returns the reason why the operator cannot move the arm by hand. */
export function jogReason(state: CellState | undefined, ended: string | undefined): string | undefined {
  if (state === undefined) {
    return "There is no arm yet.";
  }
  if (ended !== undefined) {
    return ended;
  }
  if (state.mode !== "manual") {
    return "Choose the manual working mode to jog.";
  }
  return state.power ? undefined : "Switch the power on to jog.";
}

/** Returns the reason why Run is disabled. It starts an application again that has ended, or whose tasks have all failed; Play continues a run. */
export function runReason(isPaused: boolean, isOver: boolean, canRestart: boolean): string | undefined {
  if (isOver) {
    return canRestart ? undefined : "The run is over. Start it again in the editor.";
  }
  const paused = canRestart ? "The run is paused. Press Play to continue." : "The debugger has stopped the run. Continue in the editor.";
  return isPaused ? paused : "The application is running.";
}
