import assert from "node:assert/strict";
import { test } from "node:test";
import type { Message, Scene } from "../src/protocol";
import { framesOf } from "../src/recording";
import { Samples } from "../src/samples";
import { shared } from "../src/sharing";
import { Store } from "../src/store";
import type { MotionMessage } from "../src/wire";
import { messages, recording } from "./sample.mjs";

const LIST = messages("operator") as (Message | Buffer)[];

function bytes(buffer: Buffer): ArrayBuffer {
  return Uint8Array.from(buffer).buffer;
}

function filled(role: Scene["role"] = "operator"): Store {
  const store = new Store();
  for (const message of messages(role) as (Message | Buffer)[]) {
    if (Buffer.isBuffer(message)) {
      store.takeSamples(bytes(message));
    } else if (message.kind !== "end") {
      store.take(message);
    }
  }
  return store;
}

test("samples are found by their times", () => {
  const samples = new Samples();
  LIST.filter((message) => Buffer.isBuffer(message)).forEach((batch) => samples.add(bytes(batch)));
  assert.equal(samples.count, 5000);
  assert.equal(samples.at(0)?.t, 0.004);
  assert.ok(Math.abs((samples.at(7.001)?.t ?? 0) - 7) < 1e-9);
  assert.equal(samples.at(1000)?.t, 20);
  assert.deepEqual([samples.at(4)?.tool, samples.at(4)?.source, samples.at(4)?.limit, samples.at(4)?.joints.length], [1, 1, 1, 6]);
  samples.cut(1.002);
  assert.equal(samples.count, 250);
});

test("batches that are cut short or unknown do no harm", () => {
  const samples = new Samples();
  assert.equal(samples.add(new ArrayBuffer(3)), undefined);
  assert.equal(samples.add(Uint8Array.from([2, 6, 0, 0, 1, 0, 0, 0]).buffer), undefined);
  assert.equal(samples.add(Uint8Array.from([1, 6, 0, 0, 255, 255, 255, 255]).buffer), undefined);
  assert.equal(samples.count, 0);
});

test("the page shows the newest time until a time is chosen", () => {
  const store = filled();
  const shown = (): [number, string] => [store.time.value, store.blocked.value ?? ""];
  assert.deepEqual(shown(), [20, ""]);
  store.chosen.value = 5;
  assert.deepEqual(shown(), [5, "You are looking at the past. Return to the present to operate."]);
});

test("the newest time includes the last event", () => {
  const store = filled();
  const t = store.newest.value + 0.000004;
  store.take({ kind: "events", events: [{ t, kind: "error", code: 10 }] });
  assert.equal(store.newest.value, t);
});

test("guests and recordings cannot operate", () => {
  assert.match(filled("guest").blocked.value ?? "", /guest/);
  assert.match(filled("recording").blocked.value ?? "", /recording/);
});

test("a step back forgets what came after it", () => {
  const store = filled();
  store.take({ kind: "rewind", t: 4 });
  assert.equal(store.time.value, 4);
  assert.ok((store.samples.at(1000)?.t ?? 99) <= 4);
  const { events, states } = store.panels.cell.history;
  assert.ok(events.length > 0 && events.every(({ t }) => t <= 4));
  assert.ok(states.length > 0 && states.every(({ t }) => t <= 4));
});

test("a command gets its answer, or the reason of a lost connection", async () => {
  const store = filled();
  const sent: object[] = [];
  store.send = (command) => sent.push(command);
  const [first, second] = [store.command("operate", { keys: { stop: true } }), store.command("cycle", {})];
  store.take({ kind: "answer", id: 1, error: "Not now." });
  store.lose("The connection to the run is lost.");
  assert.deepEqual(sent, [{ keys: { stop: true }, id: 1, command: "operate" }, { id: 2, command: "cycle" }]);
  assert.deepEqual([(await first).error, (await second).error], ["Not now.", "The connection to the run is lost."]);
});

test("a recording holds all messages and samples", async () => {
  let [texts, samples] = [0, 0];
  for (const frame of await framesOf(recording())) {
    if ("text" in frame) {
      texts += 1;
    } else {
      samples += 1;
    }
  }
  assert.deepEqual([samples, texts], [40, LIST.length - 40]);
});

test("an editor selects points and frames by name", () => {
  const store = filled();
  store.take({ kind: "select", name: "pHome" });
  assert.deepEqual(store.selection.value, { kind: "point", point: { name: "pHome", key: null } });
  store.take({ kind: "select", name: "fPallet" });
  assert.deepEqual(store.selection.value, { kind: "frame", name: "fPallet" });
});

test("equal parts of successive motion messages are stored once", () => {
  const piece = (x: number): MotionMessage["path"][number] => ({ phase: "nominal", points: [[x, 0, 0], [x, 1, 0]] });
  const message = (...path: MotionMessage["path"]): MotionMessage => ({ t: 1, queue: [], path });
  const first = message(piece(1), piece(2));
  const second = shared(message(piece(2), piece(3)), first);
  assert.equal(second.path[0], first.path[1]);
  assert.deepEqual(second, message(piece(2), piece(3)));
});
