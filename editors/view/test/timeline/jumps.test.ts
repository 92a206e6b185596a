import assert from "node:assert/strict";
import { test } from "node:test";
import { jumpFrom } from "../../src/timeline/jumps";

const EVENTS = [
  { t: 1, kind: "move", phase: "recorded" }, { t: 2, kind: "move", phase: "started" }, { t: 3, kind: "print", text: "on" },
  { t: 4, kind: "move", phase: "started" }, { t: 5, kind: "error", code: 60 },
];

test("moves and errors are found in both directions", () => {
  assert.equal(jumpFrom(EVENTS, "move", 0, true), 2);
  assert.equal(jumpFrom(EVENTS, "move", 2, true), 4);
  assert.equal(jumpFrom(EVENTS, "move", 4, false), 2);
  assert.equal(jumpFrom(EVENTS, "error", 0, true), 5);
  assert.equal(jumpFrom(EVENTS, "error", 5, true), undefined);
  assert.equal(jumpFrom(EVENTS, "error", 5, false), undefined);
});
