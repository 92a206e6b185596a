import assert from "node:assert/strict";
import { test } from "node:test";
import { jumpFrom } from "../../src/timeline/jumps";

const EVENTS = [
  { t: 1, kind: "move", phase: "recorded" }, { t: 2, kind: "move", phase: "started" }, { t: 3, kind: "print", text: "on" },
  { t: 4, kind: "move", phase: "started" }, { t: 5, kind: "error", code: 60 },
  { t: 6, kind: "clearance", state: "near" }, { t: 7, kind: "clearance", state: "clear" }, { t: 8, kind: "clearance", state: "contact" },
];

test("moves, errors and encounters are found in both directions", () => {
  assert.equal(jumpFrom(EVENTS, "move", 0, true), 2);
  assert.equal(jumpFrom(EVENTS, "move", 2, true), 4);
  assert.equal(jumpFrom(EVENTS, "move", 4, false), 2);
  assert.equal(jumpFrom(EVENTS, "error", 0, true), 5);
  assert.equal(jumpFrom(EVENTS, "error", 5, true), 8);
  assert.equal(jumpFrom(EVENTS, "error", 5, false), undefined);
  assert.equal(jumpFrom(EVENTS, "near", 0, true), 6);
  assert.equal(jumpFrom(EVENTS, "near", 6, true), 8);
  assert.equal(jumpFrom(EVENTS, "near", 8, true), undefined);
});
