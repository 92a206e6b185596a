// A synthetic run of a palletiser: its messages, and the page with them as a recording.
import { readFileSync } from "node:fs";
import { gzipSync } from "node:zlib";
import { encoded } from "./sampleBatch.mjs";

const AXES = [180, 130, 145, 270, 120, 270].map((limit) => ({ isLinear: false, min: -limit, max: limit, speed: 300 }));
const LINKS = [[0, 0, 478, "z"], [50, 0, 0, "y"], [0, 0, 425, "y"], [0, 50, 0, "z"], [0, 0, 425, "y"], [0, 0, 100, "z"]]
  .map(([x, y, z, axis]) => ({ offset: [x, y, z, 0, 0, 0], axis: axis === "z" ? [0, 0, 1] : [0, 1, 0] }));
/** Names may contain HTML. */
export const HOSTILE = "p<img src=x onerror=alert(1)>";
export const PHASES = ["nominal", "blend", "alter", "connection", "compliant", "stopping", "waiting"];
export const LIMITS = ["acceleration of axis 1", "speed of axis 3", "tvel"];
const OBJECTS = [
  { name: "gripper", colour: "#d9a400", carrier: { kind: "flange" }, shapes: [{ kind: "capsule", from: [0, 0, 20], to: [0, 0, 100], radius: 30, pose: [0, 0, 0, 0, 0, 0] }] },
  { name: "fence", colour: null, carrier: { kind: "world" }, shapes: [{ kind: "box", size: [1200, 40, 900], pose: [0, 900, 450, 0, 0, 0] }] },
  { name: "pallet", colour: "#9a6b3f", carrier: { kind: "frame", name: "fPallet" }, shapes: [{ kind: "box", size: [400, 300, 120], pose: [200, 150, -60, 0, 0, 0] }] },
];
const PARTS = ["carton[0]", "carton[1]"].map((name) => ({ name, colour: "#b5793a", shapes: [{ kind: "box", size: [120, 80, 100], pose: [0, 0, 0, 0, 0, 0] }] }));
/** The first carton is gripped, carried and released on the pallet; the second is removed. */
const HANDLED = [
  { t: 0, first: { carrier: { kind: "world" }, pose: [700, -300, 50, 0, 0, 0] }, second: { kind: "world" } },
  { t: 4, first: { carrier: { kind: "flange" }, pose: [0, 0, 170, 0, 0, 0] }, second: { kind: "world" } },
  { t: 12, first: { carrier: { kind: "frame", name: "fPallet" }, pose: [200, 150, 50, 0, 0, 0] }, second: null },
].map(({ t, first, second }) => ({ kind: "parts", t, parts: [{ name: "carton[0]", ...first }, { name: "carton[1]", carrier: second, pose: [700, -500, 50, 0, 0, 0] }] }));
const HANDLING = [
  { t: 4, kind: "grip", gripper: "tGripper", part: "carton[0]", nearest: "carton[0]", distance: 0.4, within: 5 },
  { t: 12, kind: "release", gripper: "tGripper", part: "carton[0]" }, { t: 12, kind: "part", part: "carton[1]", state: "removed" },
  { t: 14, kind: "grip", gripper: "tGripper", part: null, nearest: "carton[0]", distance: 212.3, within: 5 },
];
/** A near miss, and a contact that lasts up to the end. */
const ENCOUNTERS = [[15.2, "near", "fence", 18], [15.8, "clear", "fence", 12.1], [17, "near", "pallet", 9], [17.4, "contact", "pallet", -3.4]].map(([t, state, b, distance]) => ({
  t, kind: "clearance", state, a: "gripper", b, distance, points: [[560, 240, 300], [560 + Math.max(distance, 0), 240, 300]], at: t, joints: [0, 20, 80, 0, 80, 0], id: 4, type: "movel", program: "start", line: 12,
}));
const DURATION = 20;
const CYCLE = 0.004;

function signals() {
  return Array.from({ length: 1000 }, (_, index) => {
    const [board, number] = [Math.floor(index / 50), index % 50];
    const isDigital = number % 10 !== 9;
    return {
      link: `Board-${board}\\%${number < 25 ? "I" : "Q"}${number}`, names: number % 3 === 0 ? [`io<b>${index}</b>`] : [], board: `Board-${board}`,
      direction: number < 25 ? "input" : "output", isDigital, unit: isDigital ? null : "bar",
    };
  });
}

export function scene(role = "recording") {
  const point = (name, key, father, local) => ({ name, key, father, local, pose: local, config: null, file: "/cell/palletiser/palletiser.dtx", line: 4 });
  return {
    kind: "scene", version: 1, role, application: "palletiser", arm: { name: "TX2-90", axes: AXES, links: LINKS, flange: [0, 0, 0, 0, 0, 0] }, base: [0, 0, 0, 0, 0, 0], objects: OBJECTS, parts: PARTS,
    tools: [{ name: "tGripper", key: null, father: null, local: [0, 0, 120, 0, 0, 0], pose: [0, 0, 120, 0, 0, 0] }], frames: [{ name: "fPallet", key: null, father: null, local: [500, 200, 0, 0, 0, 30], pose: [500, 200, 0, 0, 0, 30] }],
    points: [point("pHome", null, null, [600, 0, 700, 180, 0, 180]), point("pPick", "0", "fPallet", [10.5, 20, 30, 180, 0, 0]), point("pPick", "1", "fPallet", [110.5, 20, 30, 180, 0, 0]), point(HOSTILE, null, "fPallet", [0, 0, 0, 0, 0, 0])],
    joints: [], signals: signals(), phases: PHASES, limits: LIMITS, lines: [{ link: "Socket\\host", type: "socket" }, { link: "Serial\\port1", type: "serial" }], userScreens: ["", "scMain"],
  };
}

function state(t, cycle) {
  const task = (name, program, line, more) => ({ name, state: "running", program, line, file: `/cell/palletiser/${program}.pgx`, priority: 10, period: null, overruns: 0, error: null, waits: null, ...more });
  const waits = cycle % 3 === 0 ? { state: "waiting", waits: "the arm (`waitEndMove`)" } : {};
  const failed = t > 16 ? { state: "error", error: 60 } : { state: "waiting", waits: "the operator (`get`)" };
  return {
    kind: "state", t, power: true, mode: "manual", emergencyStop: "none", isHeld: false, monitorSpeed: 50, moveId: cycle, phase: "nominal",
    tasks: [task("main", "start", 10 + (cycle % 5), waits), task("ioSync", "io", 3, { priority: null, period: 0.01, overruns: 2 }), task("hmi", "hmi", 5, failed)],
  };
}

/** Programs with the lines of the tasks, one of them long. Code may contain HTML. */
function programs() {
  const program = (name, lines) => ({ name, file: `/cell/palletiser/${name}.pgx`, line: name === "start" ? 8 : 2, code: lines });
  const call = (name, number) => [["text", `  ${name}(pPick[`], ["number", String(number)], ["text", "],tGripper,mFast)"]];
  return {
    kind: "programs", t: 0, application: "palletiser", programs: [
      program("start", [[["keyword", "begin"]], [["text", "  "], ["comment", "// <img src=x onerror=alert(1)>"]], ...Array.from({ length: 9 }, (_, index) => call("movel", index)), [["keyword", "end"]]]),
      program("io", [[["keyword", "begin"]], [["text", "  "], ["keyword", "if"], ["text", " sMode=="], ["string", '"fast"']], [["text", "  "], ["keyword", "endIf"]], [["keyword", "end"]]]),
      program("hmi", [[["keyword", "begin"]], ...Array.from({ length: 5000 }, (_, index) => call("movej", index)), [["keyword", "end"]]]),
    ],
  };
}

function motion(t, cycle) {
  return {
    kind: "motion", t, path: [{ phase: "nominal", points: Array.from({ length: 40 }, (_, index) => [554 - index * 4, 170 + index * 8, 638 - index * 10]) }],
    queue: [{ id: cycle, type: "movel", source: 1, phase: "nominal", target: [600, 100, 300, 180, 0, 0], leave: null, reach: null, leaveDistance: 20, reachDistance: 20 }],
  };
}

/** Returns the messages in order; a buffer is a batch of samples. */
export function messages(role) {
  const all = [scene(role), programs(), { kind: "source", index: 1, instruction: "movel", program: "start", line: 12, file: "/cell/palletiser/start.pgx" }, { kind: "tool", index: 1, name: "tGripper", pose: [0, 0, 120, 0, 0, 0] }];
  all.push({ kind: "io", t: 0, changes: signals().map(({ link }) => ({ link, value: 0, isLocked: link.endsWith("I3"), isSimulated: false, isProtected: false, fault: link.endsWith("I5") ? "its device has failed" : null })) });
  all.push({ kind: "page", t: 0, screen: "scMain", title: "Palletiser <b>1</b>", lines: ["Layer  1 of 4", "Parts  0".padEnd(40), "Gripper closed".padEnd(40), ...Array(10).fill(""), "Start Stop Home                    Quit "], modes: [[], [], [[8, 0], [6, 3]]] });
  for (let cycle = 0; cycle * 0.5 < DURATION; cycle += 1) {
    const t = cycle * 0.5;
    const move = (at, phase) => ({ t: at, kind: "move", id: cycle, phase, type: "movel", program: "start", line: 10 + (cycle % 5) });
    all.push({ kind: "events", events: [move(t, "recorded"), move(t + 0.02, "started")] }, state(t + 0.02, cycle), motion(t + 0.02, cycle), samples(t, 0.5));
    all.push({ kind: "events", events: [...(cycle % 5 === 0 ? [] : [move(t + 0.4, "blend")]), move(t + 0.48, "done"), { t: t + 0.48, kind: "log", level: cycle === 7 ? "error" : "info", text: `part ${cycle} <i>placed</i>` }] });
    all.push(...HANDLED.filter((message) => message.t > t - 0.01 && message.t <= t + 0.49));
    all.push({ kind: "events", events: HANDLING.filter((event) => event.t > t - 0.01 && event.t <= t + 0.49) });
    all.push({ kind: "events", events: ENCOUNTERS.filter((event) => event.t > t - 0.01 && event.t <= t + 0.49) });
    all.push({ kind: "io", t: t + 0.49, changes: signals().slice(0, 200).map(({ link, isDigital }) => ({ link, value: isDigital ? cycle % 2 : Math.sin(cycle / 3) * 5, isLocked: false, isSimulated: false, isProtected: false, fault: null })) });
  }
  all.push({ kind: "events", events: [{ t: 5, kind: "sio", link: "Socket\\host", dir: "in", bytes: [79, 75, 13, 10] }] });
  all.push({ kind: "data", t: 12, points: [{ name: "pPick", key: "1", pose: [600, 210, 40, 180, 0, 30], local: [111, 20, 30, 180, 0, 0] }] });
  all.push({ kind: "end", t: DURATION, reason: "finished", exitCode: 0 });
  return all;
}

function samples(start, duration) {
  const count = Math.round(duration / CYCLE);
  return encoded(Array.from({ length: count }, (_, index) => {
    const t = Number((start + (index + 1) * CYCLE).toFixed(3));
    const joints = [40 * Math.sin(t), 20 + 10 * Math.sin(2 * t), 80, 0, 80 - 10 * Math.sin(2 * t), 40 * t / DURATION];
    return { t, joints, speed: 250, phase: index > count * 0.8 ? 1 : 0, tool: 1, source: 1, limit: index % LIMITS.length };
  }));
}

/** Returns the content of the element `recording` in an exported page. */
export function recording(list = messages()) {
  const frames = list.map((message) => {
    const content = Buffer.isBuffer(message) ? message : Buffer.from(JSON.stringify(message));
    const head = Buffer.alloc(5);
    head.writeUInt8(Buffer.isBuffer(message) ? 1 : 0, 0);
    head.writeUInt32LE(content.length, 1);
    return Buffer.concat([head, content]);
  });
  return gzipSync(Buffer.concat(frames)).toString("base64");
}

/** Returns the page with a recording. */
export function exported(page = readFileSync(new URL("../dist/view.html", import.meta.url), "utf8")) {
  return page.replace("<body>", `<body><script id="recording" type="text/plain">${recording()}</script>`);
}
