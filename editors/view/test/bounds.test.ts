import assert from "node:assert/strict";
import { test } from "node:test";
import { MOST_MESSAGES, since } from "../src/bounds";
import type { RunMessage, Scene } from "../src/protocol";
import { Store } from "../src/store";
import { messages } from "./sample.mjs";

const RUN = (messages("operator") as (RunMessage | Buffer)[]).filter((message): message is RunMessage => !Buffer.isBuffer(message));

function filled(log: readonly RunMessage[]): Store {
  const store = new Store();
  log.forEach((message) => store.take(message));
  return store;
}

/** Returns the state of the panels at a time. */
function shown(store: Store, t: number): unknown[] {
  store.chosen.value = t;
  const { page, points, motion } = store.panels.cell;
  const state = store.panels.cell.state.value;
  const events = store.panels.cell.history.events.filter((event) => event.t >= 7.3 && event.t <= t);
  return [state && { ...state, t: 0 }, page.value && { ...page.value, t: 0 }, points.value, motion.value, events];
}

void test("what is later than the kept time is shown as before", () => {
  const [whole, part] = [filled(RUN), filled(since(RUN, 7.3))];
  for (const t of [7.3, 7.52, 9, 12, 12.1, 19.99]) {
    assert.deepEqual(shown(part, t), shown(whole, t), `${t} s`);
  }
});

void test("a long run is kept in part", (context) => {
  context.mock.timers.enable({ apis: ["setTimeout"] });
  const store = filled([RUN[0] as Scene]);
  for (let index = 0; index <= MOST_MESSAGES * 2; index += 1) {
    store.take({ kind: "io", t: index, changes: [{ link: `%I${index % 3}`, value: index, isLocked: false, isSimulated: false, isProtected: false, fault: null }] });
  }
  assert.ok(store.oldest.value > MOST_MESSAGES / 2, `${store.oldest.value}`);
  const { signals } = store.panels.cell.history;
  assert.ok(signals.of("%I0").length < MOST_MESSAGES / 2);
  assert.equal(signals.of("%I1")[0]?.[0], store.oldest.value);
  assert.equal(store.newest.value, MOST_MESSAGES * 2);
});
