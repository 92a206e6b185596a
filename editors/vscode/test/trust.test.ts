import assert from "node:assert/strict";
import { readdirSync, readFileSync } from "node:fs";
import { join } from "node:path";
import { afterEach, test } from "node:test";
import * as vscode from "vscode";
import { checkTrust, whenTrusted } from "../src/trust";
import type * as documents from "./documents";

// The stand-in for these tests, see vscode.ts.
const { takeMessages, trusted, workspace } = vscode as unknown as typeof documents;

interface Manifest {
  capabilities: { untrustedWorkspaces: { supported: string; restrictedConfigurations: string[] } };
  contributes: {
    commands: { command: string; enablement?: string }[];
    menus: Record<string, { command: string; when?: string }[]>;
  };
}

/** Commands of the manifest that execute a folder's programs, load its shapes, or connect to the address in it. */
const EXECUTING = ["val3.tree.run", "val3.tree.debug", "val3.showRobot",
  ...["pull", "compare", "push", "pushApplication", "showChanges"].map((name) => `val3.controller.${name}`)];
/** Settings that choose the executed command. */
const SERVER = ["val3.server.path", "val3.server.arguments"];

afterEach(() => (workspace.isTrusted = true));

/** Returns a feature that counts its registrations. */
function counted(): { count: number; register: () => vscode.Disposable[] } {
  const feature = {
    count: 0,
    register: () => {
      feature.count += 1;
      return [new vscode.Disposable(() => (feature.count -= 1))];
    },
  };
  return feature;
}

test("in a trusted folder a feature is registered immediately", () => {
  const feature = counted();
  const registration = whenTrusted(feature.register);
  assert.equal(feature.count, 1);
  registration.dispose();
  assert.equal(feature.count, 0);
  assert.ok(checkTrust("Running a program"));
  assert.deepEqual(takeMessages(), []);
});

test("in another folder a feature is registered when the user trusts it", () => {
  workspace.isTrusted = false;
  const feature = counted();
  whenTrusted(feature.register);
  assert.equal(feature.count, 0);
  assert.ok(!checkTrust("Running a program"));
  assert.deepEqual(takeMessages(), ["Running a program executes code of this folder, which you do not trust."]);
  workspace.isTrusted = true;
  trusted.fire();
  assert.equal(feature.count, 1);
});

test("the manifest restricts what executes programs", () => {
  const manifest = JSON.parse(readFileSync(join(__dirname, "../../package.json"), "utf8")) as Manifest;
  const { supported, restrictedConfigurations } = manifest.capabilities.untrustedWorkspaces;
  assert.equal(supported, "limited");
  assert.deepEqual(restrictedConfigurations, SERVER);
  for (const name of EXECUTING) {
    const command = manifest.contributes.commands.find(({ command }) => command === name);
    assert.equal(command?.enablement, "isWorkspaceTrusted", name);
  }
});

/** All files in which the extension starts a process, each with the protection against code in an untrusted folder. */
const STARTS: Record<string, string> = {
  "client.ts": "the server, which only reads",
  "controller/process.ts": "registered by whenTrusted",
  "debug/adapter.ts": "made by debug/register.ts in trusted folders",
  "debug/lenses.ts": "checkTrust",
  "debug/view/preview.ts": "isTrusted",
  "tasks.ts": "a task, which VS Code executes only in trusted folders",
  "testing/commands.ts": "registered by whenTrusted",
  "testing/debugging.ts": "registered by whenTrusted",
  "testing/process.ts": "registered by whenTrusted",
};

test("every start of a process is guarded", () => {
  const source = join(__dirname, "../../src");
  const files = readdirSync(source, { recursive: true, encoding: "utf8" }).filter((file) => file.endsWith(".ts"));
  const starts = /(?<![.\w])(spawn|exec|execFile|fork)\(|promisify\(exec|\.(createTerminal|startDebugging|runHandler)\(|(Process|Shell)Execution\(|new \w*Client\("val3"/;
  const starting = files.filter((file) => starts.test(readFileSync(join(source, file), "utf8")));
  assert.deepEqual(starting.map((file) => file.replaceAll("\\", "/")).sort(), Object.keys(STARTS).sort());
});
