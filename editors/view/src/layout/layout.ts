// Layout of the page: whether the panels are shown, and their share of the page. Both survive a reload.

import { signal } from "@preact/signals";
import { remember, remembered } from "../memory";

/** The panels are next to the picture on a wide page, and below it on a tall one. */
export type Side = "beside" | "below";

/** Media query of a page that has its panels below the picture. view.css has the same one. */
export const TALL = "(max-width: 860px) and (max-aspect-ratio: 1/1)";

/** Smallest and largest share of the panels, in per cent. */
export const [LEAST, MOST] = [15, 80] as const;

/** Step of the arrow keys, in per cent. */
const STEP = 2;

/** Chosen shares in per cent; `undefined` for the default of the style sheet. */
const shares = { beside: signal(storedShare("beside")), below: signal(storedShare("below")) };

const chosen = { recording: signal(remembered("panels.recording")), run: signal(remembered("panels.run")) };

export function share(side: Side): number | undefined {
  return shares[side].value;
}

/** Sets the share of the panels; `undefined` restores the default. */
export function setShare(side: Side, percent: number | undefined): void {
  shares[side].value = percent === undefined ? undefined : bounded(percent);
  remember(`share.${side}`, String(shares[side].value ?? ""));
}

/** Whether the panels are shown. A recording begins without them. */
export function hasPanels(isRecording: boolean): boolean {
  return (chosen[isRecording ? "recording" : "run"].value ?? (isRecording ? "hidden" : "shown")) === "shown";
}

export function showPanels(isRecording: boolean, isShown: boolean): void {
  const kind = isRecording ? "recording" : "run";
  chosen[kind].value = isShown ? "shown" : "hidden";
  remember(`panels.${kind}`, chosen[kind].value);
}

export function bounded(percent: number): number {
  return Math.min(Math.max(percent, LEAST), MOST);
}

/** Parses a stored share; `undefined` if the text is no share. */
export function parsedShare(text: string | undefined): number | undefined {
  const percent = Number(text);
  return text !== undefined && text !== "" && Number.isFinite(percent) ? bounded(percent) : undefined;
}

/** Returns the share to which a key moves the border; `undefined` for other keys. */
export function movedShare(key: string, side: Side, percent: number): number | undefined {
  const [larger, smaller] = side === "beside" ? ["ArrowLeft", "ArrowRight"] : ["ArrowUp", "ArrowDown"];
  switch (key) {
    case larger: return bounded(percent + STEP);
    case smaller: return bounded(percent - STEP);
    case "Home": return LEAST;
    case "End": return MOST;
    default: return undefined;
  }
}

function storedShare(side: Side): number | undefined {
  return parsedShare(remembered(`share.${side}`));
}
