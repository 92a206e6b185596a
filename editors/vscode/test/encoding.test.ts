// Encodings of files, and texts that were read in the wrong encoding.

import assert from "node:assert/strict";
import { test } from "node:test";
import { encodingsOf, isDeclaredAlike, isSameEncoding } from "../src/encoding/declared";
import type { Replacement } from "../src/codeView/projection";
import { asReferences, asUtf8, restore } from "../src/encoding/rescue";

const declared = (encoding: string, text = ""): Buffer => Buffer.from(`<?xml version="1.0" encoding="${encoding}"?>${text}`, "latin1");
const MARK = Buffer.from([0xef, 0xbb, 0xbf]);

test("the encoding of a file is the one that it declares, and its bytes survive", () => {
  assert.deepEqual(encodingsOf(declared("ISO-8859-1")), ["iso88591"]);
  assert.deepEqual(encodingsOf(declared("iso-8859-1", "é")), ["iso88591"]);
  assert.deepEqual(encodingsOf(declared("Windows-1252", "é")), ["windows1252", "iso88591"]);
  assert.deepEqual(encodingsOf(declared("GBK")), ["gbk", "iso88591"]);
  assert.deepEqual(encodingsOf(Buffer.from("<?xml version='1.0' encoding='latin1'?>")), ["iso88591"]);
});

test("a file that declares UTF-8 or nothing is in UTF-8 unless its bytes are not", () => {
  assert.deepEqual(encodingsOf(declared("utf-8")), ["utf8"]);
  assert.deepEqual(encodingsOf(declared("us-ascii")), ["utf8"]);
  assert.deepEqual(encodingsOf(Buffer.from("<a>é</a>")), ["utf8"]);
  assert.deepEqual(encodingsOf(declared("utf-8", "é")), ["iso88591"]);
  assert.deepEqual(encodingsOf(Buffer.from("<a>é</a>", "latin1")), ["iso88591"]);
});

test("a byte order mark takes precedence over the declaration", () => {
  assert.deepEqual(encodingsOf(Buffer.concat([MARK, declared("iso-8859-1")])), ["utf8"]);
  assert.deepEqual(encodingsOf(Buffer.concat([MARK, Buffer.from([0xe9])])), ["iso88591"]);
  assert.deepEqual(encodingsOf(Buffer.from([0xff, 0xfe, 0x3c, 0])), []);
  assert.ok(isDeclaredAlike(Buffer.concat([MARK, declared("utf-8")]), declared("UTF-8", "é")));
  assert.ok(!isDeclaredAlike(declared("iso-8859-1"), declared("utf-8")));
  assert.ok(isSameEncoding("utf8", "utf8bom") && !isSameEncoding("utf8", "iso88591"));
});

test("lost characters are restored in their places", () => {
  const right = "café, crème\r\n";
  const read = "caf\ufffd, cr\ufffdme\r\n";
  assert.equal(restore("// caf\ufffd, cold cr\ufffdme\n", read, right), "// café, cold crème\n");
  assert.equal(restore(read, read, right), right);
  assert.equal(restore("a\ufffd\ufffdb", "\ufffd\ufffd", "éè"), "aéèb");
  // Three bytes that begin a UTF-8 character are read as one character.
  assert.equal(restore("x \ufffdy", "\ufffdy", "é¦y"), "x é¦y");
});

test("characters that can no longer be identified are not restored", () => {
  assert.equal(restore("caf", "caf\ufffd", "café"), undefined);
  assert.equal(restore("caf\ufffd", "caf\ufffd", "tea"), undefined);
  // Two bytes that happen to be a UTF-8 character.
  assert.equal(restore("é\ufffd", "é\ufffd", "Ã©è"), undefined);
});

const changed = (text: string, changes: Replacement[]): string =>
  [...changes].reverse().reduce((text, { start, end, text: now }) => text.slice(0, start) + now + text.slice(end), text);
const isLatin = (letter: string): boolean => letter <= "\xff";

test("characters that an encoding lacks become references, except in CDATA sections", () => {
  const text = '<a b="é中">\u{1f600}<![CDATA[é]]></a>';
  assert.equal(changed(text, asReferences(text, isLatin) ?? []), '<a b="é&#20013;">&#128512;<![CDATA[é]]></a>');
  assert.equal(asReferences('<a><![CDATA[put("€")]]></a>', isLatin), undefined);
  assert.deepEqual(asReferences("<a>é</a>", isLatin), []);
});

test("the declaration of a file becomes UTF-8", () => {
  const head = (name: string): string => `<?xml version='1.0' encoding = '${name}' ?><a/>`;
  assert.equal(changed(head("iso-8859-1"), asUtf8(head("iso-8859-1"))), head("utf-8"));
  assert.deepEqual(asUtf8(head("UTF-8")), []);
  assert.deepEqual(asUtf8("<a encoding='x'/>"), []);
});
