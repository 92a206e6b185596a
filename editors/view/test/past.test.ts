// A page that was opened late has in the end the content of a page from the beginning.
import assert from "node:assert/strict";
import { test } from "node:test";
import { since } from "../src/bounds";
import type { Chain } from "../src/kinematics";
import { partOf } from "../src/part";
import type { Message, RunMessage } from "../src/protocol";
import { RunLog } from "../src/runLog";
import { Trail } from "../src/scene/trail";
import { Store } from "../src/store";
import { messages, scene } from "./sample.mjs";

type Received = Message | Buffer;

const LIST = messages("operator") as Received[];
const isLasting = (message: Received): boolean => !Buffer.isBuffer(message) && ["scene", "source", "tool"].includes(message.kind);
const LASTING = LIST.filter(isLasting);
const RUN = LIST.filter((message) => !isLasting(message));

/** Beginnings of the parts, as indices of messages; the first part begins with the run. */
const PARTS = [0, 40, 45, 120, 121, 200];

function bytes(buffer: Buffer): Uint8Array {
  return Uint8Array.from(buffer);
}

function receive(store: Store, received: readonly Received[]): Store {
  received.forEach((message) => (Buffer.isBuffer(message) ? store.takeBytes(bytes(message)) : store.take(message)));
  return store;
}

/** Returns the message with the part of a run between two indices. */
function block(run: readonly Received[], start: number, end: number): Buffer {
  const before = new RunLog();
  for (const message of run.slice(0, start)) {
    if (Buffer.isBuffer(message)) {
      before.samples.add(bytes(message));
    } else if (message.kind === "rewind") {
      before.cut(message.t);
    } else {
      before.add(message as RunMessage);
    }
  }
  const t = Math.max(0, ...before.messages.flatMap((message) => ("t" in message ? [message.t] : [])));
  const sample = run.slice(0, start).findLast((message) => Buffer.isBuffer(message));
  const state: Received[] = start === 0 ? [] : [...since(before.messages, t).filter((message) => message.kind !== "events"), ...(sample === undefined ? [] : [sample])];
  const frames = [...state, ...run.slice(start, end)].map((message) => {
    const content = Buffer.isBuffer(message) ? message : Buffer.from(JSON.stringify(message));
    const head = Buffer.alloc(5);
    head.writeUInt8(Buffer.isBuffer(message) ? 1 : 0, 0);
    head.writeUInt32LE(content.length, 1);
    return Buffer.concat([head, content]);
  });
  const head = Buffer.alloc(16);
  head.writeUInt8(2, 0);
  head.writeUInt32LE(state.length, 4);
  head.writeDoubleLE(start === 0 ? 0 : t, 8);
  return Buffer.concat([head, ...frames]);
}

const past = (from: number, to: number): Message => ({ kind: "past", from, to });

/** Returns the messages of a viewer that connects after `present` messages of a run with parts. */
function late(run: readonly Received[], parts: readonly number[], present: number): { entrance: Received[]; older: Received[] } {
  const begun = parts.filter((start) => start <= present);
  const blocks = begun.map((start, index) => block(run, start, begun[index + 1] ?? present)).reverse();
  const [newest = Buffer.alloc(0), ...older] = blocks;
  const to = newest.readDoubleLE(8);
  return { entrance: [...LASTING, past(0, to), newest], older: [...older, past(0, 0)] };
}

/** Waits until all received parts are inserted. */
async function read(store: Store): Promise<void> {
  for (let attempt = 0; store.past.from.value !== undefined; attempt += 1) {
    assert.ok(attempt < 1000, "the past is read");
    await new Promise((resolve) => setTimeout(resolve, 1));
  }
}

/** Returns everything that the panels and the picture show, as texts. */
function contentOf(store: Store): Record<string, string> {
  const { history } = store.panels.cell;
  const { events, faults, transfers, states, segments, encounters, moves } = history;
  const samples = [...store.samples.columnsFrom(0)].map(({ sample, joints, index }) => [sample, joints.map((column) => column[index])]);
  const shown = [0, 3, 4.2, 7.52, 9, 12.1, 16.5, 20].map((t) => {
    store.chosen.value = t;
    const { cell } = store.panels;
    return [cell.state.value, cell.page.value, cell.points.value, cell.motion.value, cell.parts.value];
  });
  store.chosen.value = undefined;
  const { arm, signals } = scene("operator") as { arm: Chain; signals: { link: string }[] };
  const trail = new Trail();
  trail.follow(store.samples, arm, { position: [0, 0, 0], rotation: [[1, 0, 0], [0, 1, 0], [0, 0, 1]] }, [], () => [0, 0, 100]);
  const content = {
    times: [store.oldest.value, store.newest.value, store.end.value, [...history.rests()]],
    events, faults, transfers, states, samples, shown,
    chart: segments.names().map((name) => [name, segments.of(name)]),
    encounters: encounters.list,
    moves: moves.all(),
    changes: signals.map(({ link }) => history.signals.of(link)),
    trail: Array.from({ length: 3000 }, (_, index) => trail.piece(index)),
  };
  return Object.fromEntries(Object.entries(content).map(([name, part]) => [name, JSON.stringify(part)]));
}

/** Checks that two pages have the same content. */
function checkSame(late: Store, early: Record<string, string>, text: string): void {
  const content = contentOf(late);
  assert.deepEqual(Object.keys(early).filter((name) => content[name] !== early[name]), [], text);
}

void test("a late page has the content of an early one after it has read the past", async () => {
  const early = contentOf(receive(new Store(), LIST));
  for (const present of [60, 201, RUN.length]) {
    const { entrance, older } = late(RUN, PARTS, present);
    const store = receive(new Store(), entrance);
    receive(store, [...older.slice(0, 2), ...RUN.slice(present), ...older.slice(2)]);
    await read(store);
    checkSame(store, early, `after ${present} messages`);
  }
});

void test("a late page shows and operates the present before it reads the past", () => {
  const [early, store] = [receive(new Store(), LIST), receive(new Store(), late(RUN, PARTS, RUN.length).entrance)];
  const present = ({ newest, blocked, panels: { cell } }: Store): unknown => [newest.value, blocked.value, { ...cell.page.value, t: 0 }, cell.points.value, { ...cell.state.value, t: 0 }];
  assert.deepEqual(present(store), present(early));
  assert.ok(store.oldest.value > 0 && store.earliest.value === 0);
  assert.deepEqual(store.shown.value, early.shown.value);
});

void test("a time that is not there yet is awaited", async () => {
  const { entrance, older } = late(RUN, PARTS, RUN.length);
  const store = receive(new Store(), entrance);
  store.chosen.value = 1;
  assert.deepEqual([store.awaited.value, store.time.value], [1, store.oldest.value]);
  receive(store, older);
  await read(store);
  assert.deepEqual([store.awaited.value, store.time.value], [undefined, 1]);
  assert.equal(store.panels.cell.motion.value.queue[0]?.id, 1);
});

void test("parts before a time to which a debugger has gone back end there", async () => {
  const back: Message = { kind: "rewind", t: 6.1 };
  const again: Message = { kind: "rewind", t: 4.3 };
  const runs = [
    [...RUN.slice(0, 150), back, ...RUN.slice(150)],
    [...RUN.slice(0, 42), ...RUN.slice(42, 119), again, back, ...RUN.slice(119)],
  ];
  for (const run of runs) {
    const early = contentOf(receive(new Store(), [...LASTING, ...run]));
    for (const present of [60, 140, run.length]) {
      const { entrance, older } = late(run, PARTS, present);
      const store = receive(new Store(), entrance);
      receive(store, [...run.slice(present), ...older]);
      await read(store);
      checkSame(store, early, `after ${present} messages`);
    }
  }
});

void test("a lost connection ends the reading", async () => {
  const { entrance, older } = late(RUN, PARTS, RUN.length);
  const store = receive(new Store(), entrance);
  store.chosen.value = 1;
  store.lose("The connection to the run is lost.");
  receive(store, older);
  await read(store);
  assert.equal(store.chosen.value, store.oldest.value);
  assert.ok(store.oldest.value > 0 && store.earliest.value === store.oldest.value);
});

void test("damaged parts do no harm", () => {
  const store = receive(new Store(), late(RUN, PARTS, RUN.length).entrance);
  for (const damaged of [Buffer.from([2]), Buffer.from([2, ...Array<number>(14).fill(255)])]) {
    receive(store, [damaged]);
  }
  assert.deepEqual(partOf(Uint8Array.from([2, ...Array<number>(15).fill(0), 0, 9])).messages, []);
});

void test("parts are read in slices, between which the page handles input", async () => {
  const change = (index: number): Message => ({ kind: "io", t: index * 0.01, changes: [{ link: "BasicIO-1\\%I0", value: index % 2, isLocked: false, isSimulated: false, isProtected: false, fault: null }] });
  const run = Array.from({ length: 40_000 }, (_, index) => change(index));
  const { entrance, older } = late(run, [0, 39_990], run.length);
  const store = receive(new Store(), entrance);
  let turns = 0;
  const timer = setInterval(() => (turns += 1));
  receive(store, older);
  await read(store);
  clearInterval(timer);
  assert.equal(store.panels.cell.history.signals.of("BasicIO-1\\%I0").length, run.length);
  assert.ok(turns > 1, `${turns} turns of the event loop`);
});
