import assert from "node:assert/strict";
import { test } from "node:test";
import { faultOf } from "../../src/panels/tasks/faults";

test("faults have a cause, a task, a line and a move", () => {
  const error = { t: 1, kind: "error", task: "start", code: 20, message: "index out of range", program: "start", line: 11, file: "start.pgx" };
  const source = { program: "start", line: 11, file: "start.pgx" };
  assert.deepEqual(faultOf(error), { t: 1, text: "Error 20: index out of range in task start at start:11", source, move: undefined });
  const path = faultOf({ t: 2, kind: "fault", id: 7, type: "movel", text: "out of reach", program: "pick", line: 3, file: "pick.pgx" });
  assert.deepEqual([path?.text, path?.move], ["The arm cannot follow the path of movel: out of reach at pick:3", 7]);
  assert.deepEqual(faultOf({ t: 9, kind: "lacking", instruction: "encOn" })?.source, undefined);
  assert.equal(faultOf({ t: 0, kind: "print", text: "x" }), undefined);
});
