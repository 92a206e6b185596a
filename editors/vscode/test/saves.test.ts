// Saving a file that VS Code has read in the wrong encoding: its characters are restored, or its content remains and a
// message is shown.

import assert from "node:assert/strict";
import { mkdtempSync, readFileSync, rmSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { after, afterEach, before, test } from "node:test";
import * as vscode from "vscode";
import { openDocument, registerEncodings } from "../src/encoding/documents";
import type * as documents from "./documents";

// The stand-in for these tests, see vscode.ts.
const { holdDisk, reloadFirst, takeMessages } = vscode as unknown as typeof documents;

const HEAD = '<?xml version="1.0" encoding="iso-8859-1" ?>\r\n';
const ESCAPED = `${HEAD}<code>begin\r\n  // total, arrêt\r\n  sDrink=&quot;café&quot;\r\nend</code>\r\n`;
const SECTION = `${HEAD}<Code><![CDATA[begin\r\n  // total, arrêt\r\nend]]></Code>\r\n`;
const LOST = "\ufffd";

const folder = mkdtempSync(join(tmpdir(), "val3-saves-"));
const path = join(folder, "cup.pgx");
const faults: unknown[] = [];
let registered: vscode.Disposable[] = [];

before(() => (registered = registerEncodings((fault) => faults.push(fault))));
after(() => {
  registered.forEach((listener) => void listener.dispose());
  rmSync(folder, { recursive: true });
});
afterEach(() => {
  standIns(vscode.workspace.textDocuments).forEach((document) => document.close());
  assert.deepEqual(faults, []);
});

function standIns(all: readonly vscode.TextDocument[]): documents.TextDocument[] {
  return all as unknown as documents.TextDocument[];
}

/** Waits for background work of the extension. */
async function until(isDone: () => boolean): Promise<void> {
  for (let attempt = 0; attempt < 500 && !isDone(); attempt += 1) {
    await new Promise((resolve) => setTimeout(resolve, 2));
  }
}

/**
 * Opens a file with this text. VS Code reads it again as ISO-8859-1, but does not finish before `release` is called.
 */
async function openSlowly(text: string): Promise<{ document: documents.TextDocument; release: () => void }> {
  writeFileSync(path, text, "latin1");
  const release = holdDisk();
  const [document] = standIns([await vscode.workspace.openTextDocument(vscode.Uri.parse(`file://${path}`))]);
  assert.ok(document);
  await until(() => document.encoding === "iso88591");
  assert.equal(document.encoding, "iso88591");
  assert.ok(document.getText().includes(LOST));
  return { document, release };
}

const isSaved = (expected: string): boolean => readFileSync(path, "latin1") === expected;

async function assertSaved(expected: string): Promise<void> {
  await until(() => isSaved(expected));
  assert.equal(readFileSync(path, "latin1"), expected);
}

for (const order of ["before", "after"]) {
  test(`a file that was edited while it was read again has its characters when it is saved ${order} the end of reading`, async () => {
    const { document, release } = await openSlowly(ESCAPED);
    document.replace("total", "sum");
    if (order === "after") {
      release();
    }
    await document.save();
    release();
    await assertSaved(ESCAPED.replace("total", "sum"));
    assert.equal(document.getText(), ESCAPED.replace("total", "sum"));
    assert.deepEqual(takeMessages(), []);
  });
}

test("the file keeps its content, with a message, if its characters can no longer be identified", async () => {
  for (const text of [ESCAPED, SECTION]) {
    const { document, release } = await openSlowly(text);
    document.replace(`arr${LOST}t`, "arret");
    document.replace("total", `total ${LOST}${LOST}`);
    release();
    await document.save();
    await assertSaved(text);
    assert.equal(document.getText(), text);
    assert.deepEqual(takeMessages(), [
      "cup.pgx was not changed: it was opened as utf8, but its encoding is iso88591, and characters would have been lost. Make the change again.",
    ]);
    document.close();
  }
});

test("the change can be made again", async () => {
  const { document, release } = await openSlowly(ESCAPED);
  document.replace(`arr${LOST}t`, "arret");
  release();
  await document.save();
  takeMessages();
  document.replace("arrêt", "fin d'arrêt");
  await document.save();
  await assertSaved(ESCAPED.replace("arrêt", "fin d'arrêt"));
  assert.deepEqual(takeMessages(), []);
});

test("a file that was not edited in the meantime is shown and saved in its encoding", async () => {
  const { document, release } = await openSlowly(ESCAPED);
  release();
  await until(() => document.getText() === ESCAPED);
  document.replace("total", "thé");
  await document.save();
  await assertSaved(ESCAPED.replace("total", "thé"));
});

test("a replacement character that the user types is saved like other characters", async () => {
  const { document, release } = await openSlowly(ESCAPED);
  release();
  await until(() => document.getText() === ESCAPED);
  document.replace("total", LOST);
  await document.save();
  await assertSaved(ESCAPED.replace("total", "&#65533;"));
  assert.deepEqual(takeMessages(), []);
});

test("a file that was closed without saving is read in its encoding when it is opened again", async () => {
  const { document, release } = await openSlowly(ESCAPED);
  document.replace("total", "sum");
  release();
  document.close();
  const again = await openDocument(document.uri as unknown as vscode.Uri);
  assert.equal(again.getText(), ESCAPED);
  assert.ok(!again.isDirty);
});

test("a file that was edited before it could be read again has its characters when it is saved", async () => {
  writeFileSync(path, ESCAPED, "latin1");
  // Like "Replace in Files".
  const [document] = standIns([await vscode.workspace.openTextDocument(vscode.Uri.parse(`file://${path}`))]);
  document?.replace("total", "sum");
  await document?.save();
  await assertSaved(ESCAPED.replace("total", "sum"));
  await until(() => document?.encoding === "iso88591");
  assert.equal(document?.encoding, "iso88591");
  assert.deepEqual(takeMessages(), []);
});

test("a file that becomes UTF-8 is read as UTF-8, also if VS Code reloads it meanwhile", async () => {
  writeFileSync(path, SECTION, "latin1");
  const document = await openDocument(vscode.Uri.parse(`file://${path}`));
  const [edited] = standIns([document]);
  edited?.replace("arrêt", "arrêt 中");
  reloadFirst(2);
  await edited?.save();
  const now = SECTION.replace("iso-8859-1", "utf-8").replace("arrêt", "arrêt 中");
  await until(() => document.encoding === "utf8" && document.getText() === now);
  assert.deepEqual([document.encoding, document.getText(), document.isDirty], ["utf8", now, false]);
  assert.equal(readFileSync(path, "utf8"), now);
  assert.equal(takeMessages().length, 1);
});
