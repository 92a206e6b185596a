// Results and selection of tests, without an editor.

import assert from "node:assert/strict";
import { test } from "node:test";
import { branchesOf, type CoveredFile, filesOf, lineCount, sideCount } from "../src/testing/coverage";
import { follow } from "../src/testing/process";
import { LineReader, output, placeOf, sides } from "../src/testing/results";
import { batches, testArguments } from "../src/testing/selection";

const failure = { message: "2 instead of 3", places: [{ program: "a:p", file: "", line: 4 }, { program: "a:t", file: "t.pgx", line: 5 }] };
const result = { name: "aTest:testSum", program: "testSum", file: "t.pgx", line: 5, seconds: 0.004, prints: ["x"], passed: false, failure };

test("both sides of an assertion are found in its message", () => {
  assert.deepEqual(sides("2 instead of 3"), { actual: "2", expected: "3" });
  assert.deepEqual(sides('"a b" instead of ""'), { actual: '"a b"', expected: '""' });
  assert.deepEqual(sides("2 instead of 3 (1 away, tolerance 0.5)"), { actual: "2", expected: "3" });
  const pose = "1 mm and 0 degrees away\n  actual    {1,0}\n  expected  {2,0}";
  assert.deepEqual(sides(pose), { actual: "{1,0}", expected: "{2,0}" });
  assert.equal(sides("the value is 1 degree away"), undefined);
  assert.equal(sides("use this instead of that one"), undefined);
});

test("a failure is at its innermost place with a file", () => {
  assert.equal(placeOf(failure)?.line, 5);
  assert.equal(placeOf({ message: "", places: [] }), undefined);
});

test("the output has a line for the test, its message and what it has printed", () => {
  assert.equal(output(result), "FAIL aTest:testSum (0.004 s of controller time)\r\n     2 instead of 3\r\n     | x\r\n");
  const others = { ...failure, others: [{ message: "a\nb", places: [] }] };
  assert.match(output({ ...result, failure: others }), / 2 instead of 3\r\n {5}a\r\n {5}b\r\n/);
  assert.equal(output({ ...result, prints: [], passed: true, failure: null }), "ok   aTest:testSum (0.004 s of controller time)\r\n");
  const skipped = { kind: "skipped" as const, reason: "no scale" };
  const head = "skip aTest:testSum (0.004 s of controller time), skipped: no scale\r\n";
  assert.equal(output({ ...result, prints: [], passed: true, failure: null, exemption: skipped }), head);
});

test("lines that arrive in parts are passed on whole", () => {
  const lines: string[] = [];
  const reader = new LineReader((line) => lines.push(line));
  ["a", "b\nc", "\n\nd"].forEach((text) => reader.push(text));
  assert.deepEqual(lines, ["ab", "c"]);
});

const tests = (path: string, ...names: string[]): { name: string; path: string }[] => names.map((name) => ({ name, path }));

test("one process executes whole applications without naming their tests", () => {
  const all = [...tests("/one", "a:x", "a:y"), ...tests("/two", "b:x")];
  const [batch, ...others] = batches(all, all);
  assert.equal(others.length, 0);
  assert.deepEqual(batch && testArguments(batch), ["test", "--format", "json-lines", "--", "/one", "/two"]);
});

test("single tests are named", () => {
  const all = tests("/one", "a:x", "a:y");
  const [batch] = batches(tests("/one", "a:y"), all);
  assert.deepEqual(batch && testArguments(batch, "/tmp/c.json"),
    ["test", "--format", "json-lines", "--exact", "a:y", "--coverage-output", "json=/tmp/c.json", "--", "/one"]);
});

test("a scenario is found by its file, also if the folder of an application contains it", () => {
  const all = [...tests("/one", "one:x"), ...tests("/one/tests/s.toml", "one:s")];
  const whole = batches(all, all).map((batch) => testArguments(batch).slice(3));
  assert.deepEqual(whole, [["--", "/one", "/one/tests/s.toml"]]);
  assert.deepEqual(batches(all.slice(0, 1), all).map(({ names }) => names), [["one:x"]]);
  assert.deepEqual(batches(all.slice(1), all).map((batch) => testArguments(batch).slice(3)), [["--", "/one/tests/s.toml"]]);
});

test("tests of the same name are executed by different processes", () => {
  const all = [...tests("/one", "a:x"), ...tests("/other", "b:x"), ...tests("/two", "a:x")];
  assert.deepEqual(batches(all, all).map(({ paths }) => paths), [["/one", "/other"], ["/two"]]);
});

const covered: CoveredFile = {
  file: "a.pgx",
  lines: [{ line: 3, hits: 2 }, { line: 4, hits: 0 }],
  branches: [{ line: 3, sides: [{ name: "true", hits: 2 }, { name: "false", hits: 0 }] }],
};

test("covered lines and sides are counted", () => {
  assert.deepEqual(lineCount(covered), { covered: 1, total: 2 });
  assert.deepEqual(sideCount(covered), { covered: 1, total: 2 });
  assert.deepEqual(covered.lines.map((line) => branchesOf(covered, line).length), [1, 0]);
});

test("the programs of a file are one file", () => {
  const second = { ...covered, lines: [{ line: 9, hits: 1 }], branches: [] };
  const [file, ...others] = filesOf({ files: [covered, second] });
  assert.deepEqual([others, file?.lines.map(({ line }) => line), file?.branches.length], [[], [3, 4, 9], 1]);
});

const node = process.execPath;
const program = (code: string): string[] => ["-e", code];

test("a process is followed to its end", async () => {
  const lines: string[] = [];
  const code = "console.log('a'); process.stdout.write('b'); console.error('c'); process.exitCode = 2";
  const ended = await follow(node, program(code), { folder: ".", line: (line) => lines.push(line) });
  assert.deepEqual([lines, ended], [["a", "b"], { code: 2, errors: "c\n" }]);
});

test("a process that is aborted or missing ends with a reason", async () => {
  const aborted = new AbortController();
  const work = { folder: ".", aborted: aborted.signal, line: () => aborted.abort() };
  const ended = await follow(node, program("console.log('a'); setInterval(() => 0, 1000)"), work);
  assert.equal(ended.code, null);
  const missing = await follow("/nowhere/val3", [], { folder: ".", line: () => undefined });
  assert.match(missing.errors, /ENOENT/);
});
