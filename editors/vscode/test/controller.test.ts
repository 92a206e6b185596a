// The view "Controller" without an editor and without a controller.

import assert from "node:assert/strict";
import { mkdirSync, mkdtempSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { test } from "node:test";
import * as vscode from "vscode";
import { addressFault, serverOf } from "../src/controller/address";
import { type DifferingFile, parseComparison, parsePlan, type PlannedChange } from "../src/controller/answers";
import { confirmation } from "../src/controller/confirmation";
import { confirmCertificate } from "../src/controller/certificates";
import { type Compared, type ControllerNode, isLocal, isOnController, projectNode } from "../src/controller/items";
import { isLoginRejected, messageOf, notesOf, summaryOf, unknownFingerprint } from "../src/controller/messages";
import { Passwords } from "../src/controller/passwords";
import { run } from "../src/controller/process";

const project = { folder: "/cell", address: "ftp://maintenance@192.168.0.254", serial: "F10-1" };

const file = (path: string, side: DifferingFile["side"], change: DifferingFile["change"] = "changed"): DifferingFile => ({ path, side, change });

const compared: Compared = {
  time: "14:32",
  applications: [
    { name: "both", files: [file("usr/usrapp/both/a.pgx", "local"), file("usr/usrapp/both/b.pgx", "controller", "added")] },
    { name: "clash", files: [file("usr/usrapp/clash/a.pgx", "local"), { ...file("usr/usrapp/clash/clash.dtx", "conflict"), controller_change: "removed" }] },
    { name: "here", files: [file("usr/usrapp/here/sub/a.pgx", "local", "removed")] },
    { name: "same", files: [file("usr/usrapp/same/a.pgx", "alike")] },
    { name: "there", files: [file("usr/usrapp/there/a.pgx", "controller")] },
  ],
  settings: [file("usr/configs/sio.cfx", "controller")],
};

/** Formats items with their descriptions, with two spaces per level. */
function drawn(node: ControllerNode, indent = ""): string[] {
  return [`${indent}${node.label}: ${node.description}`, ...(node.children?.() ?? []).flatMap((child) => drawn(child, `${indent}  `))];
}

test("a project that was not compared shows its controller", () => {
  const node = projectNode(project, "cell", undefined);
  assert.deepEqual(drawn(node), ["192.168.0.254: F10-1, not compared"]);
  assert.equal(projectNode({ ...project, serial: "" }, "cell", undefined).description, "no serial number, not compared");
  assert.equal(projectNode({ ...project, address: "/srs/robot/" }, "cell", undefined).label, "robot");
});

test("applications have a state, and below them the files that differ", () => {
  assert.deepEqual(drawn(projectNode(project, "cell", compared)), [
    "192.168.0.254: F10-1, 7 files changed at 14:32",
    "  both: changed here and on the controller, 2 files",
    "    a.pgx: changed here",
    "    b.pgx: added on the controller",
    "  clash: conflict, 2 files",
    "    a.pgx: changed here",
    "    clash.dtx: changed here, removed on the controller",
    "  here: changed here, 1 file",
    "    sub/a.pgx: removed here",
    "  same: unchanged",
    "    a.pgx: same change on both sides",
    "  there: changed on the controller, 1 file",
    "    a.pgx: changed on the controller",
    "  Settings: changed on the controller, 1 file",
    "    usr/configs/sio.cfx: changed on the controller",
  ]);
  const equal = { ...compared, applications: [{ name: "same", files: [] }], settings: [] };
  assert.equal(projectNode(project, "cell", equal).description, "F10-1, no difference at 14:32");
});

test("only applications with local changes can be pushed", () => {
  const nodes = projectNode(project, "cell", compared).children?.() ?? [];
  const pushed = nodes.filter(({ context }) => context.includes("changed")).map(({ application }) => application);
  assert.deepEqual(pushed, ["both", "clash", "here"]);
});

test("a file that one side does not have is empty there", () => {
  const sides = (side: DifferingFile["side"], change: DifferingFile["change"]): boolean[] =>
    [isOnController(file("x", side, change)), isLocal(file("x", side, change))];
  assert.deepEqual(sides("local", "changed"), [true, true]);
  assert.deepEqual(sides("local", "added"), [false, true]);
  assert.deepEqual(sides("local", "removed"), [true, false]);
  assert.deepEqual(sides("controller", "added"), [true, false]);
  assert.deepEqual(sides("controller", "removed"), [false, true]);
  assert.deepEqual([isOnController, isLocal].map((isThere) => isThere({ ...file("x", "conflict", "removed"), controller_change: "changed" })), [true, false]);
});

test("another version of the output is an error", () => {
  assert.deepEqual(parsePlan(Buffer.from('{"version":1,"changes":[]}')).changes, []);
  assert.throws(() => parseComparison(Buffer.from('{"version":2}')), /version 2 .* reads version 1/);
});

const change = (path: string, action: PlannedChange["action"] = "replace", size: number | null = 653): PlannedChange => ({ path, action, size });

test("the confirmation lists the changes and asks whether the applications are unloaded", () => {
  const changes = [change("usr/usrapp/b/b.dtx", "create", 12_345), change("usr/usrapp/a/a.pgx"), change("usr/usrapp/a/old.pgx", "remove", null)];
  const { message, detail, applications } = confirmation(project, changes, ["note: local changes stay here"]);
  assert.equal(message, "Push 3 files to the controller F10-1 at ftp://maintenance@192.168.0.254?");
  assert.deepEqual(applications, ["a", "b"]);
  assert.deepEqual(detail.split("\n").slice(0, 4), ["add b/b.dtx (12 kB)", "replace a/a.pgx (653 bytes)", "remove a/old.pgx", "note: local changes stay here"]);
  assert.match(detail, /\n\nAre the applications a, b stopped and unloaded on the controller\? /);
});

test("a long list of changes is shortened", () => {
  const changes = Array.from({ length: 25 }, (_, index) => change(`usr/usrapp/a/${index}.pgx`));
  const { detail } = confirmation(project, changes, []);
  assert.match(detail, /19\.pgx \(653 bytes\)\nand 5 more\n\nIs the application a stopped/);
});

const REJECTED = "error: cannot log in at robot:21: 530 Login incorrect\n  help: check the profile and its password\n";

test("the message is the error with its help, or the effect of an interruption", () => {
  const errors = "/robot: controller F10-1\nerror[V0101]: `nSetle` is not declared\n   = help: did you mean\nerror: the check has found errors\n  help: repair them\n";
  assert.equal(messageOf(errors), "the check has found errors. Help: repair them");
  assert.equal(messageOf("/robot: controller F10-1\ninterrupted: no local file was changed\n"), "interrupted: no local file was changed");
  assert.equal(messageOf("/robot: controller F10-1\n"), "");
  assert.equal(summaryOf("/robot: controller F10-1\n.: 4 files of the controller (1 kB), 1 updated\n"), "4 files of the controller (1 kB), 1 updated");
  assert.deepEqual(notesOf("x\nwarning: the last push was interrupted\nnote: y\n"), ["warning: the last push was interrupted", "note: y"]);
  assert.ok(isLoginRejected(REJECTED));
  assert.ok(!isLoginRejected("error: cannot list at robot:21: 530 x"));
});

test("the certificate of a new controller is confirmed by its fingerprint", async () => {
  const fingerprint = `SHA256${":0A".repeat(32)}`;
  const error = `error: cannot start TLS at robot:21: its certificate is not known: ${fingerprint}\n  help: compare the fingerprint\n`;
  assert.equal(unknownFingerprint(error), fingerprint);
  const other = `error: cannot start TLS at robot:21: its certificate is ${fingerprint}, and the accepted one is ${fingerprint}\n`;
  assert.equal(unknownFingerprint(other), undefined);
  assert.equal(unknownFingerprint(REJECTED), undefined);
  const shown: string[] = [];
  let answer: string | undefined;
  Object.assign(vscode.window, {
    showWarningMessage: (message: string, { modal, detail }: vscode.MessageOptions, button: string) => {
      assert.equal(modal, true);
      shown.push(`${message} ${detail}`);
      answer ??= button;
      return Promise.resolve(answer);
    },
  });
  assert.equal(await confirmCertificate("ftps://robot", fingerprint), true);
  assert.ok(shown.join().includes("ftps://robot") && shown.join().includes(fingerprint));
  answer = "";
  assert.equal(await confirmCertificate("ftps://robot", fingerprint), false);
});

test("addresses are checked while they are entered", () => {
  const folder = mkdtempSync(join(tmpdir(), "val3-address-"));
  mkdirSync(join(folder, "robot/usr"), { recursive: true });
  for (const address of ["ftp://robot", "ftp://me@robot:2121/disk", " ftps://me@[::1]:21", "FTP://robot/", "robot", join(folder, "robot")]) {
    assert.equal(addressFault(address, folder), undefined, address);
  }
  for (const [address, fault] of [["", "Enter an address"], ["elsewhere", "contains no usr"], ["http://robot", "Only ftp://"],
    ["ftp://me:secret@robot", "no password"], ["ftp://", "host is missing"], ["ftp://me@", "host is missing"], ["ftp://robot:x", "port"],
    ["ftp://robot:70000", "port"]] as const) {
    assert.ok(addressFault(address, folder)?.includes(fault), `${address}: ${addressFault(address, folder)}`);
  }
});

test("the prompt names the profile and the host", () => {
  assert.deepEqual(serverOf("ftp://me@robot:2121/disk"), { profile: "me", host: "robot:2121" });
  assert.deepEqual(serverOf("ftp://robot"), { profile: "default", host: "robot" });
  assert.equal(serverOf("/emulator"), undefined);
});

test("a password is kept in memory for its address, until the controller rejects it", async () => {
  const answers = ["secret", undefined];
  const prompts: string[] = [];
  Object.assign(vscode.window, {
    showInputBox: ({ prompt, password }: vscode.InputBoxOptions) => {
      assert.equal(password, true);
      prompts.push(String(prompt));
      return Promise.resolve(answers.shift());
    },
  });
  const passwords = new Passwords();
  assert.equal(await passwords.prompt("/emulator"), false);
  assert.equal(await passwords.prompt(project.address), true);
  assert.equal(passwords.variables(project.address).VAL3_PASSWORD, "secret");
  assert.equal(passwords.variables("ftp://other").VAL3_PASSWORD, process.env.VAL3_PASSWORD);
  assert.equal(await passwords.prompt(project.address), false);
  assert.equal(passwords.variables(project.address).VAL3_PASSWORD, process.env.VAL3_PASSWORD);
  assert.match(prompts.join("\n"), /not stored.*\n.*rejected the password/);
});

test("the output of a process is passed on byte for byte", async () => {
  const script = 'process.stdout.write(Buffer.from([0xe9, 0])); process.stderr.write(`${process.env.VAL3_PASSWORD}\\n`); process.exitCode = 1';
  const seen: string[] = [];
  const variables = { ...process.env, VAL3_PASSWORD: "secret" };
  const ended = await run(process.execPath, ["-e", script], { folder: tmpdir(), variables, onCancel: () => undefined, progress: (text) => seen.push(text) });
  assert.deepEqual(ended, { code: 1, output: Buffer.from([0xe9, 0]), errors: "secret\n" });
  assert.equal(seen.join(""), "secret\n");
});

test("cancelling interrupts the process, which ends by itself", async () => {
  const script = 'process.on("SIGINT", () => { console.error("interrupted: cleaned up"); process.exit(130) }); setTimeout(() => {}, 60000); console.error("ready")';
  let cancel = (): void => undefined;
  const ended = await run(process.execPath, ["-e", script], {
    folder: tmpdir(),
    variables: process.env,
    onCancel: (listener) => (cancel = listener),
    progress: (text) => text.startsWith("ready") && cancel(),
  });
  assert.equal(ended.code, 130);
  assert.match(ended.errors, /interrupted: cleaned up/);
});

test("a command that does not exist has a message", async () => {
  const ended = await run("/absent/val3", ["status"], { folder: tmpdir(), variables: {}, onCancel: () => undefined, progress: () => undefined });
  assert.match(messageOf(ended.errors), /^\/absent\/val3 cannot be started: /);
});
