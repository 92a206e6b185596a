// Edits from the tables in the file's document, without an editor.

import assert from "node:assert/strict";
import { mkdtempSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { test } from "node:test";
import * as vscode from "vscode";
import type { Client } from "../src/client";
import { Edits } from "../src/dataEditor/edits";
import { changed, datumAt, Requests } from "../src/dataEditor/requests";
import type { DataFinding, EditDataResult } from "../src/serverRequests";
import type { TextDocument } from "./documents";

const CONTENT_MODIFIED = -32801;
const folder = mkdtempSync(join(tmpdir(), "val3-tables-"));
let count = 0;

type Answer = (version: number, check: boolean) => EditDataResult;

/** Creates a document, and a server that returns this response. */
async function made(answer: Answer): Promise<{ document: TextDocument; edits: Edits; uri: string }> {
  const path = join(folder, `${(count += 1)}.dtx`);
  writeFileSync(path, "a=1\n");
  const uri = vscode.Uri.parse(`file://${path}`);
  const document = await vscode.workspace.openTextDocument(uri);
  const client = {
    request: (_: string, parameters: unknown): Promise<unknown> => {
      const { version, check } = parameters as { version: number; check: boolean };
      return Promise.resolve().then(() => answer(version, check));
    },
  } as Pick<Client, "request">;
  return { document: document as unknown as TextDocument, edits: new Edits(document, new Requests(client, uri)), uri: uri.toString() };
}

const replacing = (uri: string, text: string): EditDataResult => {
  const range = { start: { line: 0, character: 2 }, end: { line: 0, character: 3 } };
  return { edit: { documentChanges: [{ textDocument: { uri, version: null }, edits: [{ range, newText: text }] }] }, refused: null, findings: [] };
};

test("an edit changes the document", async () => {
  const { document, edits, uri } = await made(() => replacing(uri, "2"));
  assert.deepEqual(await edits.apply([]), { refused: null, findings: [] });
  assert.equal(document.getText(), "a=2\n");
});

test("a check and a refusal change nothing", async () => {
  const finding: DataFinding = { place: { name: "a" }, column: null, severity: "error", code: "V0203", message: "Wrong." };
  const { document, edits, uri } = await made((_, check) => (check ? { ...replacing(uri, "2"), findings: [finding] } : { edit: null, refused: "No.", findings: [] }));
  assert.deepEqual(await edits.check([]), { refused: null, findings: [finding] });
  assert.deepEqual(await edits.apply([]), { refused: "No.", findings: [] });
  assert.equal(document.getText(), "a=1\n");
});

test("an edit of an older text is computed again", async () => {
  const versions: number[] = [];
  const { document, edits, uri } = await made((version) => {
    versions.push(version);
    if (versions.length === 1) {
      throw Object.assign(new Error("content modified"), { code: CONTENT_MODIFIED });
    } else if (versions.length === 2) {
      // The user types while the server responds.
      document.replace("a", "b");
    }
    return replacing(uri, "2");
  });
  assert.deepEqual(await edits.apply([]), { refused: null, findings: [] });
  assert.deepEqual([document.getText(), versions], ["b=2\n", [1, 1, 2]]);
});

test("a text that changes all the time is not edited", async () => {
  const { document, edits, uri } = await made(() => {
    document.replace("a", "aa");
    return replacing(uri, "2");
  });
  assert.match((await edits.apply([])).refused ?? "", /being changed/);
  assert.ok(document.getText().endsWith("=1\n"));
});

test("other faults of the server are faults", async () => {
  const { edits } = await made(() => {
    throw new Error("The server is not running.");
  });
  await assert.rejects(edits.apply([]), /not running/);
});

test("a refused new name is a sentence", async () => {
  const { edits } = await made(() => assert.fail());
  assert.match((await edits.rename(new vscode.Position(0, 0), "a b")).refused ?? "", /executeDocumentRenameProvider/);
});

test("edits are applied one after the other", async () => {
  const { document, edits, uri } = await made((version) => replacing(uri, String(version + 1)));
  await Promise.all([edits.apply([]), edits.apply([])]);
  assert.equal(document.getText(), "a=3\n");
});

test("the datum at a position is the last one that begins before it", () => {
  const at = (line: number): { start: { line: number; character: number }; end: { line: number; character: number } } => ({ start: { line, character: 4 }, end: { line, character: 6 } });
  const tables = { resultId: "a", version: 1, data: [{ name: "nA", range: at(2) }, { name: "nB", range: at(5) }] };
  assert.deepEqual([[1, 9], [2, 4], [4, 0], [5, 3], [9, 0]].map(([line = 0, character = 0]) => datumAt(tables, { line, character })), [undefined, "nA", "nA", "nA", "nB"]);
});

test("changes replace data and move those after them", () => {
  const datum = (name: string, line: number): { name: string; range: { start: { line: number; character: number }; end: { line: number; character: number } } } => ({ name, range: { start: { line, character: 4 }, end: { line, character: 6 } } });
  const before = { resultId: "a", version: 1, data: [datum("nA", 2), datum("nB", 5), datum("nC", 7)] };
  const after = changed(before, { resultId: "b", version: 2, data: { start: 1, deleteCount: 1, items: [datum("nB", 5), datum("nD", 8)] }, lineShift: 3 });
  assert.deepEqual(after, { resultId: "b", version: 2, data: [datum("nA", 2), datum("nB", 5), datum("nD", 8), datum("nC", 10)] });
});
