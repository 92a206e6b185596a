import assert from "node:assert/strict";
import { test } from "node:test";
import { withChanges } from "../../src/data/changes";
import { Findings, messagesOf } from "../../src/data/findings";
import { ALL, DataModel } from "../../src/data/model";
import { freeName } from "../../src/data/NameDialogs";
import { moved, rectangleOf } from "../../src/data/selection";
import { nextOrder } from "../../src/data/sorting";
import { DATA, datum, TABLES } from "./fixture";

function model(): DataModel {
  const made = new DataModel();
  made.take(TABLES);
  return made;
}

test("a search finds names, keys and values of all types", () => {
  const shown = model();
  const found = (text: string): string[] => {
    shown.filter.value = { ...shown.filter.value, text };
    shown.shown.value = ALL;
    return shown.rows.value.map(({ label }) => label);
  };
  assert.deepEqual(found("fa[0]"), ["pA"]);
  assert.deepEqual(found("NKEYS b"), ["nKeys"]);
  assert.deepEqual(found("4"), ["tSlot"]);
  assert.deepEqual([shown.counts.value.get("Slot"), shown.counts.value.get("num")], [{ all: 1, found: 1 }, { all: 4, found: 0 }]);
});

test("access and findings filter", () => {
  const shown = model();
  shown.filter.value = { text: "", access: "public", isFaultyOnly: false };
  assert.deepEqual(shown.rows.value.map(({ label }) => label), ["nTwo"]);
  shown.take({ ...TABLES, findings: [{ place: { name: "nGrid", key: "1,0" }, column: "value", severity: "error", code: "V0001", message: "Wrong." }] });
  shown.filter.value = { text: "", access: "all", isFaultyOnly: true };
  assert.deepEqual(shown.rows.value.map(({ label }) => label), ["nGrid"]);
});

test("the selection follows its row, and another row takes the place of one that is gone", () => {
  const shown = model();
  shown.select(1, 4);
  shown.order.value = { column: "value", isDescending: true };
  assert.equal(shown.activeRow()?.label, "nTwo");
  shown.order.value = undefined;
  shown.take({ ...TABLES, data: DATA.filter(({ name }) => name !== "nTwo") });
  assert.deepEqual([shown.activeRow()?.label, shown.activeColumn()?.id], ["nGrid", "value"]);
});

test("changes replace data and findings, and keep the others", () => {
  const finding = { place: { name: "nTen", key: "0" }, column: "value", severity: "error", code: "V0001", message: "Wrong." } as const;
  const before = { ...TABLES, findings: [finding] };
  const nTwo = datum("nTwo", "num", [{ key: "0", texts: ["3"] }], { access: "public" });
  const after = withChanges(before, { version: 2, problem: null, data: { start: 1, deleteCount: 1, items: [nTwo] }, values: null, findings: null });
  assert.deepEqual(after, { ...before, version: 2, data: DATA.map((other, at) => (at === 1 ? nTwo : other)) });
  assert.equal(after.data[2], DATA[2]);
  assert.deepEqual(withChanges(after, { version: 3, problem: null, data: { start: 6, deleteCount: 0, items: [] }, values: null, findings: { start: 0, deleteCount: 1, items: [] } }).findings, []);
});

test("changed values replace those of their datum, and the others stay the same objects", () => {
  const values = ["1", "2", "3"].map((text, at) => ({ key: `${at}`, texts: [text] }));
  const before = { ...TABLES, data: [datum("nMany", "num", values, { size: [3] })] };
  const change = datum("nMany", "num", [{ key: "1", texts: ["5"] }], { size: [3] });
  const after = withChanges(before, { version: 2, problem: null, data: { start: 0, deleteCount: 1, items: [change] }, values: { start: 1, deleteCount: 1 }, findings: null });
  assert.deepEqual(after.data[0]?.values.map(({ texts }) => texts[0]), ["1", "5", "3"]);
  assert.equal(after.data[0].values[2], values[2]);
});

test("a datum is revealed whatever is filtered", () => {
  const shown = model();
  shown.filter.value = { text: "nothing", access: "public", isFaultyOnly: true };
  shown.reveal("nKeys", "b");
  assert.deepEqual([shown.shown.value, shown.activeRow()?.label], ["num", '["b"]']);
  shown.reveal("nUnknown");
  assert.match(shown.notice.text.value, /nUnknown/);
});

test("a file that cannot be edited says why", async () => {
  const shown = model();
  shown.take({ ...TABLES, problem: "Line 3 has a syntax error." });
  assert.equal(await shown.edit([{ kind: "delete", names: ["nTen"] }]), false);
  assert.equal(shown.notice.text.value, "Line 3 has a syntax error.");
});

test("arrow keys stay within the table, and with Control go to its ends", () => {
  const extent = { rows: 5, columns: 3, page: 2 };
  assert.deepEqual(moved({ row: 0, column: 0 }, "ArrowUp", false, extent), { row: 0, column: 0 });
  assert.deepEqual(moved({ row: 1, column: 1 }, "ArrowDown", true, extent), { row: 4, column: 1 });
  assert.deepEqual(moved({ row: 1, column: 1 }, "PageDown", false, extent), { row: 3, column: 1 });
  assert.deepEqual(moved({ row: 1, column: 1 }, "End", true, extent), { row: 4, column: 2 });
  assert.equal(moved({ row: 1, column: 1 }, "x", false, extent), undefined);
  assert.deepEqual(rectangleOf({ row: 0, column: 2 }, { row: 3, column: 1 }), { top: 0, bottom: 3, left: 1, right: 2 });
});

test("a heading sorts in both directions and then as the file", () => {
  const ascending = nextOrder(undefined, "x");
  const descending = nextOrder(ascending, "x");
  assert.deepEqual([ascending, descending, nextOrder(descending, "x"), nextOrder(descending, "y")], [{ column: "x", isDescending: false }, { column: "x", isDescending: true }, undefined, { column: "y", isDescending: false }]);
});

test("the name of a copy is the next free number", () => {
  assert.deepEqual([freeName("pPick", new Set(["ppick2"])), freeName("pPick9", new Set())], ["pPick3", "pPick10"]);
});

test("findings are kept by cell and by datum", () => {
  const finding = { place: { name: "nTen", key: "0" }, column: "value", severity: "error", code: "V0001", message: "Wrong." } as const;
  const findings = new Findings([finding]);
  assert.deepEqual([findings.below("nTen").length, findings.below("nTwo").length, messagesOf([finding])], [1, 0, "Wrong. (V0001)"]);
});
