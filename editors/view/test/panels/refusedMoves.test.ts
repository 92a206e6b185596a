import assert from "node:assert/strict";
import { test } from "node:test";
import { RefusedMoves } from "../../src/panels/tasks/refusedMoves";

const event = (t: number, phase: string, target?: readonly number[]) =>
  ({ t, id: 1, phase, type: "movel", program: "pick", line: 4, ...(target === undefined ? {} : { target }) });

test("a refused move is shown until the program goes on", () => {
  const moves = new RefusedMoves();
  [event(1, "recorded"), event(2, "error", [900, 0, 1500]), event(5, "recorded"), event(6, "error")].forEach((one) => moves.add(one));
  assert.deepEqual([1, 2, 4.9, 5, 7].map((t) => moves.at(t).length), [0, 1, 1, 0, 0]);
  assert.deepEqual(moves.at(3)[0]?.target, [900, 0, 1500]);
  moves.clear();
  assert.deepEqual(moves.at(3), []);
});
