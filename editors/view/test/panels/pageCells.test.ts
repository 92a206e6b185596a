import assert from "node:assert/strict";
import { test } from "node:test";
import { menuTexts, spansOf } from "../../src/panels/pendant/pageCells";

test("a line is divided where its text mode changes", () => {
  const spans = spansOf("abcdef", [[2, 0], [2, 1], [1, 2], [1, 3]]);
  assert.deepEqual(spans.map(({ text }) => text.trimEnd()), ["ab", "cd", "e", "f", ""]);
  assert.deepEqual(spans.map(({ isInverse, isFlashing }) => [isInverse, isFlashing]),
    [[false, false], [true, false], [false, true], [true, true], [false, false]]);
});

test("a line has 40 columns, of which a wide character takes two", () => {
  assert.equal(spansOf("").map(({ text }) => text).join("").length, 40);
  const spans = spansOf("中b", [[2, 1]]);
  assert.deepEqual(spans.map(({ text }) => text.length), [1, 38]);
  assert.equal(spansOf("e\u0301x", [[1, 1]])[0]?.text, "e\u0301");
});

test("runs of wrong lengths do no harm", () => {
  assert.equal(spansOf("ab", [[-3, 1], [1e9, 1]]).map(({ text }) => text).join("").length, 40);
});

test("the last line has the texts of the menu keys", () => {
  assert.deepEqual(menuTexts("Open Close     Stop "), ["Open", "Close", "", "Stop", "", "", "", ""]);
  assert.deepEqual(menuTexts("开关 Help"), ["开关", "Help", "", "", "", "", "", ""]);
});
