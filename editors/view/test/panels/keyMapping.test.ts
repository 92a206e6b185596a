import assert from "node:assert/strict";
import { test } from "node:test";
import { characterCode, type PendantKey, pendantKey, type TypedKey } from "../../src/panels/pendant/keyMapping";

function typed(key: string, more: Partial<TypedKey> = {}): PendantKey | undefined {
  return pendantKey({ key, code: "", altKey: false, ctrlKey: false, metaKey: false, shiftKey: false, isAltGraph: false, isComposing: false, ...more });
}

test("named keys and characters are keys of the pendant", () => {
  assert.deepEqual(["Enter", "Escape", "Delete", "F1", "F8", "ArrowUp", "PageDown"].map((key) => typed(key)),
    [270, 255, 263, 271, 278, 261, 267].map((code) => ({ code })));
  assert.deepEqual(["a", "A", "1", " ", "é", "中"].map((key) => typed(key)), [97, 65, 49, 32, 233, 0x4e2d].map((code) => ({ code })));
});

test("Tab stays with the browser, and Insert takes its place", () => {
  assert.equal(typed("Tab"), undefined);
  assert.equal(typed("Tab", { shiftKey: true }), undefined);
  assert.deepEqual([typed("Insert"), typed("Insert", { shiftKey: true })], [{ code: 259 }, { code: 260 }]);
});

test("Alt with a digit is a key at the edge of the pendant", () => {
  assert.deepEqual(typed("¡", { altKey: true, code: "Digit1" }), { code: 281 });
  assert.deepEqual(typed("3", { altKey: true, code: "Numpad3" }), { code: 283 });
  assert.equal(typed("4", { altKey: true, code: "Digit4" }), undefined);
});

test("shortcuts of the browser are not taken, characters of AltGr are", () => {
  assert.equal(typed("c", { ctrlKey: true }), undefined);
  assert.equal(typed("l", { metaKey: true }), undefined);
  assert.equal(typed("a", { isComposing: true }), undefined);
  assert.deepEqual(typed("@", { ctrlKey: true, altKey: true, isAltGraph: true }), { code: 64 });
});

test("F9 and F10 change the user page", () => {
  assert.deepEqual([typed("F9"), typed("F10"), typed("F9", { shiftKey: true }), typed("F10", { shiftKey: true })],
    [{ page: "previous" }, { page: "next" }, { page: "first" }, { page: "last" }]);
});

test("codes of keys without a character write none", () => {
  assert.deepEqual(["\n", "\u007f", "ÿ", "ě", "\u{1f600}", "", "ab"].map(characterCode), Array(7).fill(undefined));
});
