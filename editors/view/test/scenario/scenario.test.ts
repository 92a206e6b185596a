import assert from "node:assert/strict";
import { test } from "node:test";
import { nameFault, scenarioFrom } from "../../src/scenario/scenario";

test("names are file names", () => {
  for (const name of ["twoBoxes", "two_boxes-2", "a".repeat(64)]) {
    assert.equal(nameFault(name), undefined, name);
  }
  for (const name of ["", "../x", "a b", "a.toml", "ä", "a".repeat(65)]) {
    assert.match(nameFault(name) ?? "", /letters/, name);
  }
});

test("a response has a file, a text and remarks", () => {
  const scenario = { file: "tests/a.toml", text: "[expect]\n", remarks: ["the page"] };
  assert.deepEqual(scenarioFrom({ error: null, ...scenario }), scenario);
});
