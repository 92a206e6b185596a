// The server from the user's view: a crash, a failed start, and changes of the open folders.
const { chmodSync, cpSync, mkdirSync, mkdtempSync, readdirSync, readFileSync, realpathSync, writeFileSync } = require("node:fs");
const { tmpdir } = require("node:os");
const { join } = require("node:path");
const { runSteps } = require("./steps");

const folder = realpathSync(mkdtempSync(join(tmpdir(), "val3-server-")));
const workspace = join(folder, "cells.code-workspace");
const cell = (name) => join(folder, name);
const SETTINGS = { "val3.server.path": "" };

/** Sets the folders of the workspace, like the dialogs for it. */
function setFolders(...names) {
  writeWorkspace(names.map((name) => ({ path: cell(name) })));
}

function writeWorkspace(folders) {
  writeFileSync(workspace, JSON.stringify({ folders, settings: SETTINGS }, undefined, 2));
}

/** Sets another server, like the settings editor. */
function setServer(path) {
  SETTINGS["val3.server.path"] = path;
  writeWorkspace(JSON.parse(readFileSync(workspace, "utf8")).folders);
}

/** Copies the example under another name, with a separate fault in a program. */
function makeCell(name) {
  cpSync(join(process.env.VAL3_ROOT, "examples/palletiser/usr"), join(cell(name), "usr"), { recursive: true });
  const program = join(cell(name), "usr/usrapp/palletiser/home.pgx");
  writeFileSync(program, readFileSync(program, "utf8").replace("begin\n", `begin\n  ${name}=1\n`));
}

/** Returns the processes of this test's server. */
function servers() {
  const isServer = (id) => {
    try {
      const words = readFileSync(`/proc/${id}/cmdline`, "utf8").split("\0");
      return words[0].startsWith(folder) && words[0].endsWith("val3.recorded") && words[1] === "lsp";
    } catch {
      return false;
    }
  };
  return readdirSync("/proc").filter((name) => /^\d+$/.test(name) && isServer(name)).map(Number);
}

async function until(holds, what) {
  for (let attempt = 0; attempt < 200 && !holds(); attempt += 1) {
    await new Promise((resolve) => setTimeout(resolve, 50));
  }
  if (!holds()) {
    throw new Error(what);
  }
}

/** Returns the number of servers that were initialized so far. */
function begun() {
  return readFileSync(join(process.env.VAL3_OUTPUT, "traces/val3-server.jsonl"), "utf8").split('"method": "initialized"').length;
}

/** Kills the running server and waits until it has ended. */
async function kill() {
  await until(() => servers().length === 1, "no server runs");
  const [id] = servers();
  process.kill(id, "SIGKILL");
  await until(() => !servers().includes(id), "the server lives on");
}

const found = (user, name, count = 1) => user.problems(`\`${name}\``, count);

const STEPS = {
  async "the findings of every folder are listed"(user) {
    await user.openFile("start.pgx");
    await user.keys("Control+Shift+M");
    await found(user, "nLeft");
    await found(user, "nRight");
  },

  async "a folder that is added is looked at"(user) {
    setFolders("nLeft", "nRight", "nThird");
    await found(user, "nThird");
    await found(user, "nLeft");
  },

  async "a folder that is taken away is no longer looked at"(user) {
    setFolders("nLeft", "nThird");
    await found(user, "nRight", 0);
    await found(user, "nLeft");
    await found(user, "nThird");
  },

  async "a server that dies is started again"(user) {
    await kill();
    await user.told("The VAL 3 server ended unexpectedly. It is started again.");
    await found(user, "nThird");
    await found(user, "nLeft");
  },

  async "a server that dies again and again is given up"(user) {
    for (let death = 2; death <= 3; death += 1) {
      const before = begun();
      await kill();
      await until(() => begun() > before, "no server is started again");
    }
    // VS Code shows no fourth message within 800 ms, only a mark in the status bar.
    await user.page.waitForTimeout(1000);
    await kill();
    await found(user, "nLeft", 0);
    await user.told("The VAL 3 server ended unexpectedly 4 times within three minutes and is not started any more.", "Restart");
    await found(user, "nLeft");
  },

  async "after that its deaths are counted anew"(user) {
    await user.command("Notifications: Clear All Notifications");
    await kill();
    await user.told("It is started again.");
    await found(user, "nLeft");
  },

  async "a server that is not there"(user) {
    setServer(join(folder, "nowhere/val3"));
    await user.told("but there is no such file. Correct the setting", "Open Settings");
    await user.page.waitForSelector('.tab.active:has-text("Settings")');
    await user.page.waitForSelector('.settings-editor .view-line:has-text("val3.server.path")');
  },

  async "a server that may not be executed"(user) {
    setServer(join(folder, "plain"));
    await user.told("but that file may not be executed. Allow it");
    chmodSync(join(folder, "plain"), 0o755);
  },

  async "a command that is no server"(user) {
    await user.command("VAL 3: Restart Server");
    await user.told("does not start: it ended before it answered.");
    await found(user, "nLeft", 0);
  },

  async "the right server again"(user) {
    setServer("");
    await found(user, "nLeft");
    await found(user, "nThird");
  },

  async "a server that hangs is replaced when the user asks for it"(user) {
    await until(() => servers().length === 1, "no server runs");
    const [id] = servers();
    process.kill(id, "SIGSTOP");
    const before = begun();
    await user.command("VAL 3: Restart Server");
    await until(() => begun() > before, "no other server is started");
    await found(user, "nThird");
    await until(() => !servers().includes(id), "the old server lives on");
  },
};

["nLeft", "nRight", "nThird"].forEach(makeCell);
writeFileSync(join(folder, "plain"), "#!/bin/sh\nexit 1\n", { mode: 0o644 });
mkdirSync(join(folder, "home"));
setFolders("nLeft", "nRight");
runSteps({ name: "server", folder, open: `workspace=${workspace}`, steps: STEPS });
