// Edits of commands, and the choice of the server.

import assert from "node:assert/strict";
import { chmodSync, mkdirSync, mkdtempSync, rmSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { delimiter, join } from "node:path";
import { after, test } from "node:test";
import { nameFault } from "../src/commands/names";
import { entry } from "../src/commands/projectEntry";
import { findServer } from "../src/server";

/** Returns the project after the edit; `undefined` if there is no edit. */
function listed(project: string, name: string): string | undefined {
  const change = entry(project, name);
  return change && project.slice(0, change.start) + change.text + project.slice(change.end);
}

test("a program is listed where it belongs by name, indented like the others", () => {
  const project = '<Programs>\r\n\t\t<Program file="b.pgx" />\r\n\t\t<Program file="D.pgx" />\r\n</Programs>';
  const line = (name: string): string => `\t\t<Program file="${name}.pgx" />\r\n`;
  assert.equal(listed(project, "a"), project.replace(line("b"), line("a") + line("b")));
  assert.equal(listed(project, "c"), project.replace(line("D"), line("c") + line("D")));
  assert.equal(listed(project, "e"), project.replace(line("D"), line("D") + line("e")));
});

test("a program that is listed, in whatever letters, is not listed again", () => {
  assert.equal(listed('<Programs>\n  <Program file="Pick.pgx" />\n</Programs>', "pick"), undefined);
});

test("the first program opens the list, in either dialect", () => {
  assert.equal(listed("  <Programs />\n", "a"), '  <Programs>\n    <Program file="a.pgx" />\n  </Programs>\n');
  const old = '<project xmlns="ProjectNameSpace">\n  <programSection>\n  </programSection>\n</project>';
  assert.equal(listed(old, "a"), old.replace("<programSection>\n", '<programSection>\n    <program file="a.pgx" />\n'));
  assert.equal(listed("<Project/>", "a"), undefined);
});

test("names that VAL 3 does not take are refused with a reason", () => {
  const taken = (name: string): boolean => name === "start";
  assert.equal(nameFault("pick_2", taken), undefined);
  for (const name of ["", "2pick", "pick up", "pi-ck", "Start"]) {
    assert.notEqual(nameFault(name, taken), undefined, name);
  }
});

const folder = mkdtempSync(join(tmpdir(), "val3-server-"));
after(() => rmSync(folder, { recursive: true }));
const executable = (...path: string[]): string => {
  const file = join(folder, ...path);
  mkdirSync(join(file, ".."), { recursive: true });
  writeFileSync(file, "");
  chmodSync(file, 0o755);
  return file;
};

test("the server of the settings comes first, then the one inside, then the one on the PATH", () => {
  const name = process.platform === "win32" ? "val3.exe" : "val3";
  const own = executable("own", "my-val3");
  const onPath = executable("bin", name);
  const extension = join(folder, "extension");
  const path = ["/nowhere", join(folder, "bin"), join(folder, "own")].join(delimiter);
  assert.deepEqual(findServer({ configured: "", extension, path }), { command: onPath });
  const inside = executable("extension", "server", name);
  assert.deepEqual(findServer({ configured: "", extension, path }), { command: inside });
  assert.deepEqual(findServer({ configured: ` ${own} `, extension, path }), { command: own });
  assert.deepEqual(findServer({ configured: "my-val3", extension, path }), { command: own });
});

test("without a server there is a reason", () => {
  assert.ok("fault" in findServer({ configured: "", extension: folder, path: "/nowhere" }));
  const folderAsServer = findServer({ configured: folder, extension: folder, path: "" });
  assert.ok("fault" in folderAsServer && folderAsServer.fault.includes(folder));
});
