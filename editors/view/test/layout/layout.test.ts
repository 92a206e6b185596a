import assert from "node:assert/strict";
import { test } from "node:test";
import { hasPanels, LEAST, MOST, movedShare, parsedShare, setShare, share, showPanels } from "../../src/layout/layout";

test("the border follows the arrow keys within its limits", () => {
  assert.equal(movedShare("ArrowLeft", "beside", 40), 42);
  assert.equal(movedShare("ArrowRight", "beside", 40), 38);
  assert.equal(movedShare("ArrowUp", "below", MOST), MOST);
  assert.equal(movedShare("ArrowUp", "beside", 40), undefined);
  assert.equal(movedShare("Home", "below", 40), LEAST);
});

test("a stored share is a number within the limits, or none", () => {
  assert.deepEqual(["33.5", "", "wide", "99", undefined].map(parsedShare), [33.5, undefined, undefined, MOST, undefined]);
});

test("the sizes beside and below the picture are separate", () => {
  setShare("beside", 30);
  assert.equal(share("beside"), 30);
  assert.equal(share("below"), undefined);
  setShare("beside", undefined);
  assert.equal(share("beside"), undefined);
});

test("a recording begins without panels, a run with them", () => {
  assert.deepEqual([hasPanels(true), hasPanels(false)], [false, true]);
  showPanels(true, true);
  showPanels(false, false);
  assert.deepEqual([hasPanels(true), hasPanels(false)], [true, false]);
});
