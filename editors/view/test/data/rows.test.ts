import assert from "node:assert/strict";
import { test } from "node:test";
import { contentOf, editOf, sizeFrom } from "../../src/data/cells";
import { type GridColumn, gridColumns } from "../../src/data/columns";
import { arrayKeys, placeId } from "../../src/data/place";
import { type Row, rowsAbove, rowsOf } from "../../src/data/rows";
import { sorted } from "../../src/data/sorting";
import { DATA, datum, TYPE_MAP } from "./fixture";

const rows = (...expanded: string[]): Row[] => rowsOf(DATA, { typeOf: (name) => TYPE_MAP.get(name), isExpanded: (id) => expanded.includes(id) });
const find = (rows: Row[], label: string): Row => rows.find((row) => row.label === label) ?? assert.fail(label);
const columns = (type: string): GridColumn[] => gridColumns(TYPE_MAP.get(type), TYPE_MAP, DATA);

test("keys of arrays have their order and a comma between dimensions", () => {
  assert.deepEqual(arrayKeys([3]), ["0", "1", "2"]);
  assert.deepEqual(arrayKeys([2, 2]), ["0,0", "0,1", "1,0", "1,1"]);
});

test("a scalar shows its value in its own row, an array and a collection in rows below", () => {
  assert.deepEqual(rows().map(({ label }) => label), ["nTen", "nTwo", "nGrid", "nKeys", "pA", "tSlot"]);
  assert.equal(find(rows(), "nTen").isExpandable, false);
  assert.equal(find(rows(), "nGrid").element, undefined);
  const open = rows("nGrid", "nKeys");
  assert.deepEqual(open.filter(({ depth }) => depth === 1).map(({ label }) => label), ["[0,0]", "[0,1]", "[1,0]", "[1,1]", '["a"]', '["b"]']);
  assert.deepEqual(find(open, "[1,0]").element, { name: "nGrid", key: "1,0" });
});

test("fields that the file does not mention are those of the type", () => {
  const field = { name: "tSlot", key: "0", within: [{ name: "nTimes" }] };
  const open = rows("tSlot", placeId(field));
  assert.deepEqual(open.slice(5).map(({ label, depth }) => [label, depth]), [["tSlot", 0], ["pPick", 1], ["nTimes", 1], ["[0]", 2], ["[1]", 2]]);
  assert.deepEqual(find(open, "[1]").element, { name: "tSlot", key: "0", within: [{ name: "nTimes", key: "1" }] });
});

test("an empty key of the server means the container of a field", () => {
  assert.equal(placeId({ name: "t", key: "0", within: [{ name: "n", key: "" }] }), placeId({ name: "t", key: "0", within: [{ name: "n" }] }));
  assert.notEqual(placeId({ name: "t", key: "" }), placeId({ name: "t" }));
});

test("the rows above a place are expanded", () => {
  const element = { name: "tSlot", key: "0", within: [{ name: "nTimes", key: "1" }] };
  const open = rows(...rowsAbove(element));
  assert.ok(open.some(({ id }) => id === placeId(element)));
});

test("values that are not written show the default", () => {
  const [, , , , x, y] = columns("point");
  const row = find(rows(), "pA");
  assert.deepEqual([x, y].map((column) => column && contentOf(row, column)).map((content) => [content?.text, content?.isDefault]), [["1", false], ["0", true]]);
});

test("a table of several types has columns that name themselves", () => {
  assert.deepEqual(columns("Slot").map(({ kind }) => kind), ["name", "type", "access", "container", "size", "value", "value", "value"]);
  assert.deepEqual(columns("point").map(({ id }) => id), ["#name", "#access", "#container", "#size", "x", "y", "fatherId", "#world", "#reach"]);
});

test("an edit names the place and the column", () => {
  const [name, access, , size, value] = columns("num");
  assert.ok(name && access && size && value);
  assert.deepEqual(editOf(find(rows("nGrid"), "[0,1]"), value, "3"), { kind: "set", cells: [{ place: { name: "nGrid", key: "0,1" }, column: "value", text: "3" }] });
  assert.deepEqual(editOf(find(rows(), "nGrid"), size, "3 4"), { kind: "resize", place: { name: "nGrid" }, size: [3, 4] });
  assert.deepEqual(editOf(find(rows("nKeys"), '["a"]'), name, "c"), { kind: "renameKey", place: { name: "nKeys" }, key: "a", as: "c" });
  assert.deepEqual(editOf(find(rows(), "nTen"), access, "public"), { kind: "access", names: ["nTen"], access: "public" });
  assert.match(JSON.stringify(editOf(find(rows(), "nGrid"), size, "many")), /whole numbers/);
  assert.equal(typeof editOf(find(rows(), "nGrid"), value, "3"), "string");
});

test("sizes have up to three dimensions", () => {
  assert.deepEqual([sizeFrom("10"), sizeFrom(" 3  4 "), sizeFrom("1 2 3 4"), sizeFrom("0"), sizeFrom("1.5"), sizeFrom("")], [[10], [3, 4], undefined, undefined, undefined, undefined]);
});

test("numbers are sorted as numbers, data without a value follow", () => {
  const data = [...DATA.slice(0, 3), datum("nNone", "num", [])];
  const value = columns("num").at(-1);
  assert.deepEqual(sorted(data, value, false, TYPE_MAP).map(({ name }) => name), ["nNone", "nTwo", "nTen", "nGrid"]);
  assert.deepEqual(sorted(data, value, true, TYPE_MAP).map(({ name }) => name), ["nTen", "nTwo", "nNone", "nGrid"]);
  assert.deepEqual(sorted(data, columns("num")[0], false, TYPE_MAP).map(({ name }) => name), ["nGrid", "nNone", "nTen", "nTwo"]);
});
