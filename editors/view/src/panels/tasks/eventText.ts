// Events of a run as rows of a log.

import type * as wire from "../../wire";
import type { NamedLine } from "../program/programs";

/** Event in the format of `val3 run --events`. */
export type RunEvent = wire.RunEvent;

export type Group = "errors" | "messages" | "tasks" | "moves" | "signals" | "lines" | "page" | "robot" | "operations" | "clearance" | "parts";

/** Groups with their check box labels. */
export const GROUPS: readonly (readonly [Group, string])[] = [
  ["errors", "Errors"], ["messages", "Messages"], ["tasks", "Tasks"], ["robot", "Robot"], ["moves", "Moves"],
  ["signals", "Inputs and outputs"], ["lines", "Lines"], ["page", "User page"], ["operations", "Operations"], ["clearance", "Distances"], ["parts", "Parts and sensors"],
];

const GROUP_OF: Partial<Record<string, Group>> = {
  error: "errors", fault: "errors", lacking: "errors", stuck: "errors", print: "messages", popup: "messages", notice: "messages", log: "messages",
  task: "tasks", move: "moves", io: "signals", sio: "lines", line: "lines", put: "page", title: "page", cls: "page", html: "page",
  power: "robot", mode: "robot", clock: "robot", lib: "robot", end: "robot", act: "operations", clearance: "clearance",
  grip: "parts", release: "parts", part: "parts", sensor: "parts",
};

const MODES = ["changing", "manual", "test", "local", "remote"];

export function groupOf(event: RunEvent): Group {
  const isFault = (event.kind === "log" && event["level"] === "error") || (event.kind === "move" && event["phase"] === "error")
    || (event.kind === "task" && event["state"] === "error") || (event.kind === "clearance" && event["state"] === "contact");
  return isFault ? "errors" : (GROUP_OF[event.kind] ?? "messages");
}

/** Returns the classes of an event's row: its group, and for a line in the controller's log the level. */
export function rowClass(event: RunEvent): string {
  const level = event.kind === "log" ? ` log ${text(event["level"])}` : "";
  return `${groupOf(event)}${level}`;
}

/** Formats an event without its time. Events of unknown kinds show their fields. */
export function textOf(event: RunEvent): string {
  const say = TEXTS[event.kind];
  return say === undefined ? rest(event) : say((name) => text(event[name]));
}

/** Returns the event's program line, if it has one. */
export function lineOf(event: RunEvent): NamedLine | undefined {
  const [program, line, file] = [event["program"], event["line"], event["file"]];
  return typeof program === "string" && program !== "" && typeof line === "number" ? { program, line, file: typeof file === "string" ? file : undefined } : undefined;
}

type Fields = (name: string) => string;

const at = (field: Fields): string => `${field("program")}:${field("line")}`;
const screen = (field: Fields): string => field("screen") || "default page";

const TEXTS: Partial<Record<string, (field: Fields) => string>> = {
  print: (field) => field("text"),
  put: (field) => `${screen(field)} (${field("x")}, ${field("y")}): ${field("text")}`,
  title: (field) => `title of ${screen(field)}: ${field("text")}`,
  cls: (field) => `${screen(field)} cleared`,
  popup: (field) => `pop-up: ${field("text")}`,
  notice: (field) => field("text"),
  log: (field) => `${field("level")}: ${field("text")}`,
  task: (field) => `${field("name")} ${field("state")}${field("code") === "" ? "" : ` ${field("code")}`} at ${at(field)}`,
  error: (field) => `error ${field("code")} at ${at(field)}: ${field("message")}${field("reason") === "" ? "" : `: ${field("reason")}`}`,
  fault: (field) => `the arm cannot follow the path of ${field("type")} ${field("id")} at ${at(field)}: ${field("text")}`,
  lacking: (field) => `${field("instruction")} is not available, at ${at(field)}`,
  io: (field) => `${field("link")} = ${field("value")}`,
  sio: (field) => `${field("link")} ${field("dir") === "in" ? "received" : "sent"} ${byteCount(field("bytes"))}`,
  line: (field) => field("link"),
  clock: (field) => (field("wall") === "true" ? "real time applies" : "virtual time applies"),
  lib: (field) => `${field("op")} ${field("alias")} ${field("path")}: code ${field("code")}`,
  power: (field) => `power ${field("on") === "true" ? "on" : "off"}`,
  move: (field) => `${field("type")} ${field("id")} ${field("phase")} at ${at(field)}`,
  mode: (field) => `working mode ${MODES[Number(field("mode"))] ?? field("mode")}`,
  html: (field) => `${field("page")}, ${field("id")}: ${field("attribute")} = ${field("value")}`,
  stuck: (field) => `${field("name")} is ${field("state")} at ${at(field)}${field("awaits") === "" ? "" : `: ${field("awaits")}`}`,
  end: (field) => `end: ${field("reason")}`,
  act: (field) => `from outside: ${field("keys")}`,
  clearance: clearanceText,
  grip: gripText,
  release: (field) => `${field("gripper")} releases ${field("part")}${field("above") === "" ? "" : `, ${Number(field("above")).toFixed(0)} mm above everything below it`}`,
  part: (field) => `${field("part")} ${field("state")}`,
  sensor: (field) => (field("on") === "true" ? `${field("sensor")} detects ${field("detects")}` : `${field("sensor")} detects nothing`),
};

function gripText(field: Fields): string {
  if (field("part") !== "") {
    return `${field("gripper")} grips ${field("part")}`;
  }
  const nearest = field("nearest") === "" ? "" : `; ${field("nearest")} is ${Number(field("distance")).toFixed(1)} mm away`;
  return `${field("gripper")} grips nothing: no part within ${field("within")} mm${nearest}`;
}

function clearanceText(field: Fields): string {
  const [a, b, distance] = [field("a"), field("b"), Number(field("distance"))];
  const size = `${Math.abs(distance).toFixed(1)} mm`;
  if (field("state") === "clear") {
    return `${a} is apart from ${b}: the smallest distance was ${distance > 0 ? size : `an overlap of ${size}`}`;
  }
  if (distance > 0) {
    return `${a} is ${size} from ${b}`;
  }
  return distance < 0 ? `${a} touches ${b} by ${size}` : `${a} touches ${b}`;
}

function byteCount(list: string): string {
  const count = list === "" ? 0 : list.split(",").length;
  return `${count} ${count === 1 ? "byte" : "bytes"}`;
}

function text(value: unknown): string {
  return typeof value === "string" ? value : value === undefined || value === null ? "" : Array.isArray(value) ? value.join(",") : JSON.stringify(value);
}

function rest(event: RunEvent): string {
  const fields = Object.entries(event).filter(([name]) => name !== "t" && name !== "kind");
  return `${event.kind} ${fields.map(([name, value]) => `${name}: ${text(value)}`).join(", ")}`;
}

export interface EventFilter {
  groups: ReadonlySet<Group>;
  text: string;
}

export function shownEvents(events: readonly RunEvent[], { groups, text: written }: EventFilter): RunEvent[] {
  const words = written.toLowerCase().split(/\s+/).filter((word) => word !== "");
  return events.filter((event) => {
    if (!groups.has(groupOf(event))) {
      return false;
    }
    const whole = words.length === 0 ? "" : `${event.task ?? ""} ${textOf(event)}`.toLowerCase();
    return words.every((word) => whole.includes(word));
  });
}
