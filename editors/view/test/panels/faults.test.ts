import assert from "node:assert/strict";
import { test } from "node:test";
import { faultOf } from "../../src/panels/tasks/faults";
import { keyOf, latestOf, unhidden } from "../../src/status/unhidden";

test("faults have a cause, a task, a line and a move", () => {
  const error = { t: 1, kind: "error", task: "start", code: 20, message: "index out of range", program: "start", line: 11, file: "start.pgx" };
  const source = { program: "start", line: 11, file: "start.pgx" };
  const nothing = { code: undefined, reason: undefined, help: undefined, move: undefined };
  assert.deepEqual(faultOf(error), { t: 1, text: "Error 20: index out of range in task start at start:11", source, ...nothing });
  const path = faultOf({ t: 2, kind: "fault", id: 7, type: "movel", text: "out of reach", program: "pick", line: 3, file: "pick.pgx" });
  assert.deepEqual([path?.text, path?.move], ["The arm cannot follow the path of movel: out of reach at pick:3", 7]);
  assert.deepEqual(faultOf({ t: 9, kind: "lacking", instruction: "encOn" })?.source, undefined);
  assert.equal(faultOf({ t: 0, kind: "print", text: "x" }), undefined);
});

test("a fault has the code of its line, its reason and its remedy", () => {
  const fault = faultOf({ t: 1, kind: "error", code: 154, message: "move not possible", program: "start", line: 10, file: "start.pgx", lineCode: "movel(pSafe,flange,mFast)", reason: "movel: too far", help: "Use `isInRange` before." });
  assert.deepEqual([fault?.code, fault?.reason, fault?.help], ["movel(pSafe,flange,mFast)", "movel: too far", "Use isInRange before."]);
  assert.match(faultOf({ t: 2, kind: "fault", id: 7, type: "movel", text: "out of reach", program: "pick", line: 3, file: "pick.pgx" })?.help ?? "", /resetMotion/);
});

test("a hidden fault uncovers the fault before it", () => {
  const faults = [1, 2, 3].flatMap((t) => faultOf({ t, kind: "error", code: 20, message: "index", program: "start", line: t, file: "start.pgx" }) ?? []);
  const [first, second, third] = faults.map(keyOf);
  assert.deepEqual([latestOf(faults, undefined), latestOf(faults, first), latestOf([], first)], [2, 0, -1]);
  const shown = unhidden(faults, new Set([third ?? ""]));
  assert.deepEqual([shown.length, latestOf(shown, third), shown.map(keyOf).at(-1)], [2, 1, second]);
});
