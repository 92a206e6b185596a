import assert from "node:assert/strict";
import { test } from "node:test";
import { FailedTargets, failedMoves } from "../../src/scene/FailedTargets";
import { LIGHT } from "../../src/scene/palette";

const QUEUE = [7, 8].map((id) => ({ id, type: "movel", target: [100 * id, 0, 50], program: "pick", line: id }));
const fault = (t: number, move: number | undefined): { t: number; text: string; source: undefined; move: number | undefined } => ({ t, text: "", source: undefined, move });

test("a recorded move fails from the time of its fault on", () => {
  const faults = [fault(1, undefined), fault(2, 8), fault(3, 6)];
  assert.deepEqual(failedMoves(QUEUE, faults, 1.9), []);
  assert.deepEqual(failedMoves(QUEUE, faults, 2).map(({ id }) => id), [8]);
  assert.deepEqual(failedMoves([], faults, 9), []);
});

test("a failed target has a cross and a name, until the move is discarded", () => {
  const marks = new FailedTargets();
  marks.place(QUEUE.slice(1), 10, LIGHT);
  assert.ok(marks.object.visible);
  assert.deepEqual(marks.labels, [{ text: "movel at pick:8 fails", at: [800, 0, 50], kind: "failed" }]);
  marks.place([], 10, LIGHT);
  assert.ok(!marks.object.visible);
  assert.deepEqual(marks.labels, []);
});
