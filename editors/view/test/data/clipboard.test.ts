import assert from "node:assert/strict";
import { test } from "node:test";
import { fromText, pasted, plain, toText } from "../../src/data/clipboard";
import { gridColumns } from "../../src/data/columns";
import { rowsOf } from "../../src/data/rows";
import { DATA, datum, TYPE_MAP, TYPES } from "./fixture";

const typeOf = (name: string): (typeof TYPES)[number] | undefined => TYPE_MAP.get(name);
const rows = rowsOf(DATA.slice(0, 2), { typeOf, isExpanded: () => false });
const columns = gridColumns(TYPE_MAP.get("num"), TYPE_MAP, []);

test("cells with tabs, quotes and line ends survive the clipboard", () => {
  const data = ["a\tb", 'say "x"', "two\nlines"].map((text, index) => datum(`s${index}`, "string", [{ key: "0", texts: [text] }]));
  const texts = rowsOf(data, { typeOf, isExpanded: () => false });
  const text = toText(texts, gridColumns(TYPE_MAP.get("string"), TYPE_MAP, []), { top: 0, bottom: 2, left: 4, right: 4 });
  assert.deepEqual(fromText(text), [["a\tb"], ['say "x"'], ["two\nlines"]]);
});

test("the last line end of a spreadsheet is not a row, and empty cells are cells", () => {
  assert.deepEqual(fromText("1\t2\r\n\t4\r\n"), [["1", "2"], ["", "4"]]);
  assert.deepEqual(fromText("x"), [["x"]]);
  assert.deepEqual(fromText(""), [[""]]);
});

test("only changed cells are written, a single cell fills the rectangle", () => {
  const at = { top: 0, bottom: 1, left: 4, right: 4 };
  assert.deepEqual(pasted("10\n3", rows, columns, at), [{ kind: "set", cells: [{ place: { name: "nTwo", key: "0" }, column: "value", text: "3" }] }]);
  assert.deepEqual(pasted("7", rows, columns, at), [{ kind: "set", cells: ["nTen", "nTwo"].map((name) => ({ place: { name, key: "0" }, column: "value", text: "7" })) }]);
  assert.deepEqual(pasted("10\n2", rows, columns, at), []);
});

test("a paste that does not fit or would change names is refused", () => {
  assert.match(JSON.stringify(pasted("1\n2\n3", rows, columns, { top: 0, bottom: 0, left: 4, right: 4 })), /3 rows/);
  assert.match(JSON.stringify(pasted("nOther", rows, columns, { top: 0, bottom: 0, left: 0, right: 0 })), /cannot be pasted/);
});

test("numbers and truth values of a localised spreadsheet are understood", () => {
  const [number, , bool] = [TYPES[0]?.columns[0], 0, TYPES[2]?.columns[0]];
  assert.ok(number && bool);
  assert.deepEqual(["1,5", " -2,25 ", "3.5", "1,2,3"].map((text) => plain(text, number)), ["1.5", "-2.25", "3.5", "1,2,3"]);
  assert.deepEqual(["TRUE", "0", "maybe"].map((text) => plain(text, bool)), ["true", "false", "maybe"]);
});
