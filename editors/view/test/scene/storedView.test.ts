import assert from "node:assert/strict";
import { test } from "node:test";
import { storedView, viewKey } from "../../src/scene/storedView";

test("only six numbers are a view, or seven of a parallel picture", () => {
  assert.deepEqual(storedView("[1, 2, 3, 4, 5, 6]"), [1, 2, 3, 4, 5, 6]);
  assert.deepEqual(storedView("[1, 2, 3, 4, 5, 6, 700]"), [1, 2, 3, 4, 5, 6, 700]);
  for (const text of [undefined, "", "{", "null", "[1, 2]", "[1, 2, 3, 4, 5, null]", "[1, 2, 3, 4, 5, 6, 7, 8]"]) {
    assert.equal(storedView(text), undefined, text);
  }
});

test("cells with another arm have another view", () => {
  const key = (name: string): string => viewKey({ application: "pal", arm: { name } });
  assert.notEqual(key("tx2-60"), key("tx2-90"));
});
