import assert from "node:assert/strict";
import { chmodSync, mkdirSync, mkdtempSync, rmSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { after, test } from "node:test";
import { CrashLimit, PERIOD, TOO_MANY } from "../src/crashLimit";
import { findServer } from "../src/server";

const folder = mkdtempSync(join(tmpdir(), "val3-server-"));
after(() => rmSync(folder, { recursive: true }));

function file(name: string, mode: number): string {
  const path = join(folder, name);
  mkdirSync(join(path, ".."), { recursive: true });
  writeFileSync(path, "#!/bin/sh\n");
  chmodSync(path, mode);
  return path;
}

const find = (configured: string, path = ""): unknown => findServer({ configured, extension: join(folder, "extension"), path });

test("the server of the settings, by its path or from the PATH", () => {
  const server = file("bin/mine", 0o755);
  assert.deepEqual(find(server), { command: server });
  assert.deepEqual(find("mine", join(folder, "bin")), { command: server });
});

test("settings that name no server say what is wrong with it", () => {
  const fault = (configured: string): string => (find(configured, join(folder, "bin")) as { fault: string }).fault;
  assert.match(fault(join(folder, "nowhere")), /nowhere", but there is no such file\. Correct the setting/);
  assert.match(fault("nowhere"), /"nowhere", but no folder of the PATH has such a command\./);
  assert.match(fault(folder), /but that is a folder\./);
  assert.match(fault(file("plain", 0o644)), /plain", but that file may not be executed\. .*chmod \+x/);
});

test("the server of the extension, else the one on the PATH", () => {
  assert.match((find("") as { fault: string }).fault, /neither in the extension nor on the PATH\. Install it/);
  const onPath = file("path/val3", 0o755);
  assert.deepEqual(find("", join(folder, "path")), { command: onPath });
  const own = file("extension/server/val3", 0o755);
  assert.deepEqual(find("", join(folder, "path")), { command: own });
});

test("a server of a relative folder of the PATH is that of whoever wrote the folder", () => {
  const before = process.cwd();
  file("cloned/planted", 0o755);
  process.chdir(join(folder, "cloned"));
  try {
    for (const path of [".", "", "../cloned", ":", "./"]) {
      assert.match((find("planted", path) as { fault: string }).fault, /no folder of the PATH/, path);
    }
  } finally {
    process.chdir(before);
  }
});

test("a server that crashes four times within three minutes is not restarted", () => {
  const crashLimit = new CrashLimit();
  for (let crash = 1; crash < TOO_MANY; crash += 1) {
    assert.equal(crashLimit.add(crash), "again");
  }
  assert.equal(crashLimit.add(TOO_MANY), "enough");
  assert.equal(crashLimit.add(PERIOD + TOO_MANY), "again");
  crashLimit.reset();
  assert.equal(crashLimit.add(PERIOD + TOO_MANY), "again");
});
