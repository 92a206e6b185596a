// Bounds the memory of a long run: messages before a time are replaced by the state at that time.

import { pointText } from "./panels/points/edits";
import type { RunMessage } from "./protocol";

/** Number of messages, and of samples (an hour of motion), above which the older half is discarded. */
export const MOST_MESSAGES = 100_000;
export const MOST_SAMPLES = 900_000;

type Data = Of<"data">;
type Of<Kind extends RunMessage["kind"]> = Extract<RunMessage, { kind: Kind }>;

/** Kinds of messages that replace the previous message of the same kind. */
const WHOLE: readonly RunMessage["kind"][] = ["state", "motion", "page", "parts", "reach", "unsaved", "clock"];

/** Returns the messages up to a time, for a run that has gone back to it. */
export function upTo(log: readonly RunMessage[], t: number): RunMessage[] {
  const cut = (message: RunMessage): RunMessage => (message.kind === "events" ? { ...message, events: message.events.filter((event) => event.t <= t) } : message);
  return log.filter((message) => !("t" in message) || message.t <= t).map(cut);
}

/** Returns messages that show the same as `log` at `t` and later. */
export function since(log: readonly RunMessage[], t: number): RunMessage[] {
  const lasting: RunMessage[] = [];
  const whole = new Map<RunMessage["kind"], RunMessage>();
  const signals = new Map<string, Of<"io">["changes"][number]>();
  const points = new Map<string, Of<"data">["points"][number]>();
  const joints = new Map<string, Data["joints"][number]>();
  const [frames, tools] = [new Map<string, Data["frames"][number]>(), new Map<string, Data["tools"][number]>()];
  const later: RunMessage[] = [];
  for (const message of log) {
    if (message.kind === "events") {
      const events = message.events.filter((event) => event.t >= t);
      if (events.length > 0) {
        later.push({ ...message, events });
      }
    } else if ("t" in message && message.t > t) {
      later.push(message);
    } else if (message.kind === "io") {
      message.changes.forEach((change) => signals.set(change.link, change));
    } else if (message.kind === "data") {
      message.points.forEach((point) => points.set(pointText(point), point));
      // Runs of earlier versions have only points.
      const changed: Partial<Data> = message;
      changed.joints?.forEach((joint) => joints.set(pointText(joint), joint));
      changed.frames?.forEach((frame) => frames.set(pointText(frame), frame));
      changed.tools?.forEach((tool) => tools.set(pointText(tool), tool));
    } else if (WHOLE.includes(message.kind)) {
      whole.set(message.kind, "t" in message ? { ...message, t } : message);
    } else {
      lasting.push(message);
    }
  }
  const io: RunMessage = { kind: "io", t, changes: [...signals.values()] };
  const data: RunMessage = { kind: "data", t, points: [...points.values()], joints: [...joints.values()], frames: [...frames.values()], tools: [...tools.values()] };
  return [...lasting, io, data, ...whole.values(), ...later];
}
