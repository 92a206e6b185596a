// The code of a program file, and its positions in the file.

import assert from "node:assert/strict";
import { test } from "node:test";
import { type Lens, lensOfFile, lensToCode } from "../src/codeView/lenses";
import { Mapping } from "../src/codeView/mapping";
import { placeInCode } from "../src/codeView/place";
import { programsOf, Projection } from "../src/codeView/projection";
import { toCode, toFile } from "../src/codeView/requests";
import { type Symbol, SYMBOLS } from "../src/codeView/symbols";

const CDATA = '<Program name="a">\r\n  <Description><![CDATA[<Code>]]></Description>\r\n  <Code><![CDATA[begin\r\n  a=b[1]\r\nend]]></Code>\r\n</Program>';
const SPLIT = "<Code><![CDATA[begin\n// a]]]]><![CDATA[> b\nend]]></Code>";
const ESCAPED = '<code>begin\n  if a&lt;b and s!=&quot;&#228;&quot;\n  endIf\nend\n      </code></source>';
const FILES = [CDATA, SPLIT, ESCAPED, "<Code></Code>", "<Code>\n <![CDATA[]]>\n</Code>", "<Code><![CDATA[begin"];

function projection(file: string): Projection {
  const found = Projection.of(file);
  assert.ok(found !== undefined);
  return found;
}

/** Returns the file after its code was changed to `code`. */
function edited(file: string, code: string): string {
  const change = projection(file).replacement(code);
  return change === undefined ? file : file.slice(0, change.start) + change.text + file.slice(change.end);
}

test("code is shown without its XML", () => {
  assert.equal(projection(CDATA).code, "begin\r\n  a=b[1]\r\nend");
  assert.equal(projection(SPLIT).code, "begin\n// a]]> b\nend");
  assert.equal(projection(ESCAPED).code, 'begin\n  if a<b and s!="ä"\n  endIf\nend\n      ');
  assert.equal(projection("<Code></Code>").code, "");
});

test("a file without code has no view", () => {
  for (const file of ["", "<Program/>", "<Code/>", "<!-- <Code>begin</Code> -->", "<![CDATA[<Code>"]) {
    assert.equal(Projection.of(file), undefined, file);
  }
});

test("an edit changes what was edited, and no other byte", () => {
  assert.equal(edited(CDATA, "begin\r\n  a=b[2]\r\nend"), CDATA.replace("b[1]", "b[2]"));
  assert.equal(edited(ESCAPED, projection(ESCAPED).code.replace("a<b", "a<=b")), ESCAPED.replace("a&lt;b", "a&lt;=b"));
  assert.equal(edited(ESCAPED, projection(ESCAPED).code.replace("a<b", 'a>"<&b"')), ESCAPED.replace("a&lt;b", "a&gt;&quot;&lt;&amp;b&quot;"));
});

test("text that ends a CDATA section is taken apart, and put together again", () => {
  const whole = edited(CDATA, "begin\r\n  a=b[c[1]]>2\r\nend");
  assert.ok(whole.includes("b[c[1]]]]><![CDATA[>2"));
  assert.equal(projection(whole).code, "begin\r\n  a=b[c[1]]>2\r\nend");
  assert.equal(edited(whole, "begin\r\n  a=b[1]\r\nend"), CDATA);
});

test("any edit of any code gives the file that has it", () => {
  const words = ["]", "]]", ">", "<", "&", '"', "a", "\n", "]]>", "<![CDATA[", "</Code>", "&lt;", ""];
  let seed = 7;
  const random = (below: number): number => (seed = (seed * 1103515245 + 12345) % 2147483648) % below;
  for (const start of FILES) {
    let file = start;
    for (let step = 0; step < 400; step += 1) {
      const code = projection(file).code;
      const from = random(code.length + 1);
      const wanted = code.slice(0, from) + (words[random(words.length)] ?? "") + code.slice(from + random(4));
      file = edited(file, wanted);
      assert.equal(projection(file).code, wanted, JSON.stringify(file));
    }
  }
});

test("places lead there and back", () => {
  for (const file of FILES) {
    const { code } = projection(file);
    for (let offset = 0; offset <= code.length; offset += 1) {
      const there = projection(file).toFile(offset);
      assert.equal(projection(file).toCode(there), offset, `${file} ${offset}`);
    }
  }
});

const target = { code: "val3-code:/a.val3?file", file: "file:///a.pgx", mapping: new Mapping(projection(ESCAPED), ESCAPED) };
const inCode = { start: { line: 1, character: 5 }, end: { line: 1, character: 8 } };
const inFile = { start: { line: 1, character: 5 }, end: { line: 1, character: 11 } };

test("requests and answers are led to the file and back", () => {
  const params = { textDocument: { uri: target.code }, range: inCode, data: inCode };
  assert.deepEqual(toFile(params, target), { textDocument: { uri: target.file }, range: inFile, data: inCode });
  const edits = [{ range: inFile, newText: "a &lt; b" }];
  assert.deepEqual(toCode("textDocument/formatting", edits, target), [{ range: inCode, newText: "a < b" }]);
  const places = [{ uri: target.file, range: inFile }, { uri: "file:///b.pgx", range: inFile }];
  assert.deepEqual(toCode("textDocument/definition", places, target), [{ uri: target.code, range: inCode }, places[1]]);
});

test("semantic tokens follow entities, and those outside of the code are left out", () => {
  const file = "<a/>\n<code>x&lt;y\nz</code>";
  const mapping = new Mapping(projection(file), file);
  const answer = { data: [0, 1, 1, 9, 0, 1, 6, 1, 2, 0, 0, 5, 1, 3, 0, 1, 0, 1, 4, 0] };
  const tokens = toCode("textDocument/semanticTokens/full", answer, { ...target, mapping });
  assert.deepEqual(tokens, { data: [0, 0, 1, 2, 0, 0, 2, 1, 3, 0, 1, 0, 1, 4, 0] });
});

const TWO = '<Programs>\n  <Program name="a">\n    <Code><![CDATA[begin\n  call b()\nend]]></Code>\n  </Program>\n  <!-- <Program name="c"> -->\n'
  + '  <Program public="true" name="b">\n    <Locals><Local name="l"/></Locals>\n    <Code><![CDATA[begin\n  l=1\nend]]></Code>\n  </Program>\n</Programs>';

test("each program of a file has a view of its own", () => {
  assert.deepEqual(programsOf(TWO).map(({ name }) => name), ["a", "b"]);
  assert.equal(Projection.of(TWO, 0)?.code, "begin\n  call b()\nend");
  const second = Projection.of(TWO, 1);
  assert.equal(second?.code, "begin\n  l=1\nend");
  const change = second.replacement("begin\n  l=2\nend");
  assert.ok(change !== undefined);
  assert.equal(TWO.slice(0, change.start) + change.text + TWO.slice(change.end), TWO.replace("l=1", "l=2"));
  assert.equal(Projection.of(TWO, 2), undefined);
});

function placed(text: string): unknown {
  const before = TWO.slice(0, TWO.indexOf(text));
  const start = { line: before.split("\n").length - 1, character: before.length - before.lastIndexOf("\n") - 1 };
  return placeInCode(TWO, { start, end: { line: start.line, character: start.character + text.length } });
}

test("a definition is seen in the view where it lies in code, or is the program", () => {
  assert.deepEqual(placed("l=1"), { index: 1, range: { start: { line: 1, character: 2 }, end: { line: 1, character: 5 } } });
  const beginning = { start: { line: 0, character: 0 }, end: { line: 0, character: 0 } };
  assert.deepEqual(placed('b">'), { index: 1, range: beginning });
  assert.deepEqual(placed('a">'), { index: 0, range: beginning });
  assert.equal(placed('l"/>'), undefined);
});

test("calls from other files keep their ranges", () => {
  const calls = [{ from: { uri: "file:///b.pgx", range: inFile }, fromRanges: [inFile] }, { from: { uri: target.file, range: inFile }, fromRanges: [inFile] }];
  const expected = [calls[0], { from: { uri: target.code, range: inCode }, fromRanges: [inCode] }];
  assert.deepEqual(toCode("callHierarchy/incomingCalls", calls, target), expected);
});

const PAIR = '<Programs>\n<Program name="a">\n<Code>begin\nend</Code>\n</Program>\n<Program name="b">\n<Code>begin\nend</Code>\n</Program>\n</Programs>';

test("a lens above the name of the program stands above its code, and is resolved as the file's", async () => {
  const mapping = Mapping.of(PAIR, 1);
  assert.ok(mapping !== undefined);
  const above = (line: number): Lens => ({ range: { start: { line, character: 15 }, end: { line, character: 16 } }, data: { uri: "file:///a.pgx" } });
  const found = toCode("textDocument/codeLens", [above(1), above(5)], { ...target, mapping }) as Lens[];
  const top = { start: { line: 0, character: 0 }, end: { line: 0, character: 0 } };
  assert.deepEqual(found.map(({ range }) => range), [top]);
  const [asked] = found;
  assert.ok(asked !== undefined);
  assert.deepEqual(lensOfFile(asked)?.range, above(5).range);
  assert.equal(lensOfFile(above(5)), undefined);
  const command = { title: "1 reference", command: "show", arguments: ["file:///a.pgx", above(5).range.start, ["file"]] };
  const resolved = await lensToCode({ ...above(5), command }, asked, (places) => Promise.resolve([places, "view"]));
  assert.deepEqual(resolved.range, top);
  assert.deepEqual(resolved.command?.arguments, [target.code, top.start, [["file"], "view"]]);
  const unused = { ...above(5), command: { title: "0 references", command: "" } };
  assert.deepEqual((await lensToCode(unused, asked, () => Promise.reject(new Error()))).command, unused.command);
});

const place = (line: number, from: number, to: number): Symbol["range"] => ({ start: { line, character: from }, end: { line, character: to } });

test("the outline of a view has its program, whose parameters and locals are where the code first uses them", () => {
  const mapping = Mapping.of(TWO, 1);
  assert.ok(mapping !== undefined);
  const declaration = place(8, 20, 21);
  const local = (name: string): Symbol => ({ name, detail: "num", kind: 13, range: declaration, selectionRange: declaration });
  const program = (name: string, line: number, ...children: Symbol[]): Symbol =>
    ({ name, kind: 12, range: { start: { line, character: 2 }, end: { line: line + 5, character: 12 } }, selectionRange: declaration, children });
  const found = toCode(SYMBOLS, [program("a", 1), program("b", 7, local("l"), local("unused"))], { ...target, mapping }) as Symbol[];
  const children = [{ ...local("l"), range: place(1, 2, 3), selectionRange: place(1, 2, 3) }, { ...local("unused"), range: place(0, 0, 5), selectionRange: place(0, 0, 5) }];
  assert.deepEqual(found, [{ name: "b", kind: 12, range: { start: { line: 0, character: 0 }, end: { line: 2, character: 3 } }, selectionRange: place(0, 0, 5), children }]);
  const unknown = toCode(SYMBOLS, null, { ...target, mapping }) as Symbol[];
  assert.deepEqual(unknown.map(({ name, children }) => [name, children]), [["b", []]]);
});
