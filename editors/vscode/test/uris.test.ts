// URIs of code views, also in Theia, whose `Uri.from` does not create an instance of `Uri`.

import assert from "node:assert/strict";
import { test } from "node:test";
import * as vscode from "vscode";
import { codeUri, fileUri, programIndex, SCHEME, uriOf } from "../src/codeView/uris";

// The stand-in for these tests, see vscode.ts.
const { asArgument } = vscode as unknown as { asArgument: (uri: vscode.Uri) => object };
const FILE = vscode.Uri.parse("file:///cell/my app/pick.pgx");

test("a view is named after its file and leads back to it", () => {
  const view = codeUri(FILE);
  assert.ok(view instanceof vscode.Uri);
  assert.deepEqual([view.scheme, view.path], [SCHEME, "/cell/my app/pick.pgx/pick.pgx (code)"]);
  assert.deepEqual([fileUri(view).path, programIndex(view)], [FILE.path, 0]);
});

test("each program of a file has a view with its name", () => {
  const view = codeUri(FILE, 1, "second");
  assert.ok(view.path.endsWith("/pick.pgx (second)"));
  assert.deepEqual([fileUri(view).path, programIndex(view)], [FILE.path, 1]);
});

test("the argument of a command is a file in every editor", () => {
  const argument = asArgument(FILE);
  assert.ok(!(argument instanceof vscode.Uri));
  const file = uriOf(argument);
  assert.ok(file instanceof vscode.Uri);
  assert.equal(file.path, FILE.path);
  assert.equal(uriOf(undefined), undefined);
  assert.equal(uriOf({ item: {} }), undefined);
});
