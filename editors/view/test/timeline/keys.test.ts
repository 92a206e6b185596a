import assert from "node:assert/strict";
import { test } from "node:test";
import { take } from "../../src/timeline/keys";

test("keys move the shown time", () => {
  const done: string[] = [];
  const keys = { toggle: () => done.push("toggle"), step: (seconds: number) => done.push(String(seconds)), first: () => done.push("first"), last: () => done.push("last") };
  for (const [key, shiftKey] of [[" ", false], ["ArrowLeft", false], ["ArrowRight", true], ["Home", false], ["End", false]] as const) {
    assert.ok(take({ key, shiftKey }, keys));
  }
  assert.equal(take({ key: "a", shiftKey: false }, keys), false);
  assert.deepEqual(done, ["toggle", "-0.004", "0.1", "first", "last"]);
});
