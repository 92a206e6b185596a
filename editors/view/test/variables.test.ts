// The table of parameters and locals: the requests after an edit of a row.

import assert from "node:assert/strict";
import { test } from "node:test";
import { keptLocals, keptParameters, literalOf, moved, removed, replaced } from "../src/variables/edits";
import { kindOf, kinds, shapeOf } from "../src/variables/kinds";
import type { FromPage, Parameter, Variables } from "../src/variables/messages";
import { VariablesModel } from "../src/variables/model";
import { readSize, shownSize } from "../src/variables/sizes";

const parameter = (name: string): Parameter => ({ name, type: "num", container: "element", dimensions: 1, passing: "value", uses: 1 });
const PICK: Variables = {
  uri: "file:///pick.pgx", version: 1, program: "pick", parameters: [parameter("a"), parameter("b")],
  locals: [{ name: "l", type: "num", container: "array", size: [2, 3], uses: 0 }], types: ["num"], isOld: false, fixed: null,
};

test("an edit says where each variable was", () => {
  const kept = keptParameters(PICK.parameters);
  assert.deepEqual(kept.map(({ from, name }) => [from, name]), [[0, "a"], [1, "b"]]);
  assert.deepEqual(moved(kept, 0, 1)?.map(({ from }) => from), [1, 0]);
  assert.equal(moved(kept, 0, -1), undefined);
  assert.equal(moved(kept, 1, 2), undefined);
  assert.deepEqual(removed(kept, 0).map(({ from }) => from), [1]);
  assert.deepEqual(replaced(kept, 1, { name: "c" }).map(({ name }) => name), ["a", "c"]);
  assert.deepEqual(keptLocals(PICK.locals), [{ from: 0, name: "l", type: "num", size: [2, 3] }]);
});

test("sizes are read as they are shown, and as files write them", () => {
  assert.equal(shownSize([3, 4]), "3 x 4");
  for (const text of ["3 x 4", "3x4", " 3 4 ", "3,4", "3, 4"]) {
    assert.deepEqual(readSize(text), [3, 4], text);
  }
  for (const text of ["", "0", "a", "1 2 3 4", "-1", "1.5", "3 x"]) {
    assert.equal(readSize(text), undefined, text);
  }
});

test("container and passing are one choice", () => {
  for (const kind of kinds(false)) {
    assert.equal(kindOf(shapeOf(kind), false), kind);
  }
  // In s5 and s6 an array looks like an element by reference.
  assert.equal(kindOf({ container: "array", dimensions: 1, passing: "reference" }, true), "reference");
  assert.deepEqual(kinds(true), ["value", "reference"]);
});

test("callers pass a literal where the type has one", () => {
  assert.deepEqual(["num", "bool", "string", "frame"].map(literalOf), ["0", "false", '""', ""]);
});

test("a refusal is shown at its row until the next edit is made", async () => {
  const sent: FromPage[] = [];
  const model = new VariablesModel((message) => sent.push(message));
  assert.equal(await model.edit({ list: "locals", index: 0 }, {}), false);
  model.take({ kind: "variables", variables: PICK, hasProgram: true });
  const refused = model.edit({ list: "parameters", index: 1 }, { parameters: [] });
  model.take({ kind: "answer", id: 1, refused: "it is used" });
  assert.equal(await refused, false);
  assert.deepEqual(model.refusal.value, { list: "parameters", index: 1, reason: "it is used" });
  const focus = { list: "parameters" as const, index: 0, field: "up" };
  const done = model.edit({ list: "parameters", index: 1 }, { parameters: [] }, focus);
  model.take({ kind: "answer", id: 2, refused: null });
  assert.equal(await done, true);
  assert.equal(model.refusal.value, undefined);
  assert.deepEqual(model.focus, focus);
  assert.deepEqual(sent.map((message) => message.command === "edit" && [message.version, message.program]), [[1, "pick"], [1, "pick"]]);
});

test("a refusal belongs to one program", () => {
  const model = new VariablesModel(() => undefined);
  model.take({ kind: "variables", variables: PICK, hasProgram: true });
  model.refuse({ list: "locals", index: 0 }, "no size");
  model.take({ kind: "variables", variables: { ...PICK, version: 2 }, hasProgram: true });
  assert.notEqual(model.refusal.value, undefined);
  model.take({ kind: "variables", variables: { ...PICK, uri: "file:///drop.pgx" }, hasProgram: true });
  assert.equal(model.refusal.value, undefined);
  model.take({ kind: "variables", variables: null, hasProgram: false });
  assert.equal(model.variables.value, null);
});
