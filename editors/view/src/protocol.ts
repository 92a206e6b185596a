// Messages of a run to its viewers, version 1.

import type * as wire from "./wire";

export type { Answer as AnswerMessage, LinkShape, Role, Source, Tool } from "./wire";

export type Pose = readonly number[];

/** Arm keys that runs of earlier versions do not have. */
type LaterKeys = "shapes" | "capsules" | "height";

/** Runs of earlier versions have no length unit and no things around the arm. */
export type Scene = Omit<wire.Scene, "arm" | "objects" | "parts" | "lengthUnit"> & Partial<Pick<wire.Scene, "objects" | "parts" | "lengthUnit">> & { kind: "scene"; arm: Omit<wire.ArmChain, LaterKeys> & Partial<Pick<wire.ArmChain, LaterKeys>> };

/** Message as an object: samples arrive as bytes. */
export type Message = Exclude<wire.Message, { kind: "samples" | "scene" }> | Scene;

/** Message that belongs to the run and its recording. */
export type RunMessage = Exclude<Message, { kind: "answer" | "rewind" | "select" | "past" }>;

/** Parses a text message; `undefined` if it is not a message. */
export function messageFrom(text: string): Message | undefined {
  try {
    const value: unknown = JSON.parse(text);
    return typeof value === "object" && value !== null && "kind" in value ? (value as Message) : undefined;
  } catch {
    return undefined;
  }
}
