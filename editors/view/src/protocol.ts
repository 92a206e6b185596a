// Messages of a run to its viewers, version 1.

import type { DataMessage, EventsMessage, IoMessage, MotionMessage, PageMessage, SceneMessage, StateMessage, UnsavedMessage } from "./panels/shared/messages";

export type Role = "operator" | "guest" | "recording" | "debugger" | "preview";
export type Pose = readonly number[];

/** Shape of a link as a file in base64. */
export interface LinkShape {
  format: "glb" | "stl";
  data: string;
}

export interface Scene extends SceneMessage {
  kind: "scene";
  version: number;
  role: Role;
  application: string;
  arm: SceneMessage["arm"] & { name: string; timesNote?: string | null; shapes?: readonly (LinkShape | null)[] };
  tools: readonly { name: string; pose: Pose }[];
  phases: readonly string[];
  /** Names of the speed limits. */
  limits: readonly string[];
}

/** Line that requests moves. */
export interface Source {
  kind: "source";
  index: number;
  instruction: string;
  program: string;
  line: number;
  file: string;
}

/** Tool, from flange to tool centre point. */
export interface Tool {
  kind: "tool";
  index: number;
  name: string | null;
  pose: Pose;
}

export interface Clock {
  kind: "clock";
  t: number;
  speed: number | "max";
  isPaused: boolean;
}

export interface End {
  kind: "end";
  t: number;
  reason: string;
  exitCode: number;
}

export interface AnswerMessage {
  kind: "answer";
  id: number;
  error: string | null;
  [field: string]: unknown;
}

/** Message that belongs to the run and its recording. */
export type RunMessage =
  | Scene | Source | Tool | Clock | End
  | ({ kind: "state" } & StateMessage)
  | ({ kind: "motion" } & MotionMessage)
  | ({ kind: "io" } & IoMessage)
  | ({ kind: "page" } & PageMessage)
  | ({ kind: "events" } & EventsMessage)
  | ({ kind: "data" } & DataMessage)
  | ({ kind: "unsaved" } & UnsavedMessage)
  | { kind: "gap"; t: number };

export type Message =
  | RunMessage | AnswerMessage
  | { kind: "rewind"; t: number }
  | { kind: "select"; name: string | null };

/** Parses a text message; `undefined` if it is not a message. */
export function messageFrom(text: string): Message | undefined {
  try {
    const value: unknown = JSON.parse(text);
    return typeof value === "object" && value !== null && "kind" in value ? (value as Message) : undefined;
  } catch {
    return undefined;
  }
}
