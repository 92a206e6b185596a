// VS Code as a server on this machine, with a separate profile and extensions.
const { spawn, spawnSync } = require("node:child_process");
const { once } = require("node:events");
const { chmodSync, createWriteStream, mkdirSync, readdirSync, renameSync, writeFileSync } = require("node:fs");
const { createServer } = require("node:net");
const { basename, join } = require("node:path");

/** Settings against network access, and against dialogs that would disturb the test. */
const SETTINGS = {
  "telemetry.telemetryLevel": "off",
  "update.mode": "none",
  "update.showReleaseNotes": false,
  "extensions.autoUpdate": false,
  "extensions.autoCheckUpdates": false,
  "extensions.ignoreRecommendations": true,
  "workbench.startupEditor": "none",
  "workbench.tips.enabled": false,
  "workbench.enableExperiments": false,
  "workbench.settings.enableNaturalLanguageSearch": false,
  "workbench.secondarySideBar.defaultVisibility": "hidden",
  "security.workspace.trust.enabled": false,
  "git.enabled": false,
  "npm.fetchOnlinePackageInfo": false,
  "chat.disableAIFeatures": true,
  "chat.commandCenter.enabled": false,
  "window.commandCenter": false,
  "editor.minimap.enabled": false,
  // Text of the terminal that a test can read.
  "terminal.integrated.gpuAcceleration": "off",
  "files.autoSave": "off",
};

/** Settings with which a folder is not trusted until the user trusts it. */
const RESTRICTED = { "security.workspace.trust.enabled": true, "security.workspace.trust.startupPrompt": "never" };

/**
 * Starts VS Code with the extension installed. Returns the address of the workbench and a function that stops VS Code.
 * With the driver of its own tests, VS Code shows no modal dialogs.
 */
async function startVsCode(folder, vsix, { showsDialogs = false, isRestricted = false } = {}) {
  const environment = { ...process.env, HOME: join(folder, "home"), EXTENSIONS_GALLERY: "{}" };
  const folders = ["home", "server", "user", "extensions"].map((name) => join(folder, name));
  const [, serverData, userData, extensions] = folders;
  for (const settings of [join(userData, "User"), join(serverData, "data/Machine")]) {
    mkdirSync(settings, { recursive: true });
    writeFileSync(join(settings, "settings.json"), JSON.stringify({ ...SETTINGS, ...(isRestricted ? RESTRICTED : {}) }));
  }
  mkdirSync(join(folder, "home"), { recursive: true });
  const main = join(process.env.VAL3_VSCODE, "out/server-main.js");
  const common = [main, "--accept-server-license-terms", "--telemetry-level", "off",
    "--server-data-dir", serverData, "--user-data-dir", userData, "--extensions-dir", extensions];
  const install = spawnSync(process.execPath, [...common, "--install-extension", vsix], { env: environment, encoding: "utf8" });
  if (install.status !== 0) {
    throw new Error(`The extension cannot be installed: ${install.stdout}${install.stderr}`);
  }
  record(extensions);
  const port = await freePort();
  const server = spawn(process.execPath, [...common, "--host", "127.0.0.1", "--port", String(port),
    "--without-connection-token", ...(showsDialogs ? [] : ["--enable-smoke-test-driver"])], { env: environment });
  process.on("exit", () => server.kill());
  const log = createWriteStream(join(folder, "vscode.log"));
  server.stdout.pipe(log);
  server.stderr.pipe(log);
  const address = `http://127.0.0.1:${port}`;
  await untilReady(address);
  return { address, stop: () => stopped(server) };
}

/** Ends the server. */
async function stopped(server) {
  if (server.exitCode === null && server.signalCode === null) {
    const end = once(server, "exit");
    server.kill();
    await end;
  }
}

/** Inserts a recorder before the server in the extension. `commands.log` lists the started commands. */
function record(extensions) {
  const [extension] = readdirSync(extensions).filter((name) => /^[\w-]+\.val3-/.test(name));
  const server = join(extensions, extension, "server/val3");
  const recorded = `${server}.recorded`;
  renameSync(server, recorded);
  const recorder = join(process.env.VAL3_ROOT, "tests/editors/record");
  const [test] = /^val3-[a-z]+/.exec(basename(join(extensions, "..")));
  const trace = join(process.env.VAL3_OUTPUT, `traces/${test}.jsonl`);
  const commands = join(extensions, "../commands.log");
  // Only the language server uses the protocol.
  const script = ["#!/bin/sh", `echo "$1" >>'${commands}'`, `export VAL3_SERVER='${recorded}' VAL3_TRACE='${trace}'`,
    `case $1 in lsp) exec '${recorder}' "$@" ;; *) exec '${recorded}' "$@" ;; esac`, ""];
  writeFileSync(server, script.join("\n"));
  chmodSync(server, 0o755);
}

async function untilReady(address) {
  for (let attempt = 0; attempt < 150; attempt += 1) {
    const ready = await fetch(`${address}/version`).then((answer) => answer.ok, () => false);
    if (ready) {
      return;
    }
    await new Promise((resolve) => setTimeout(resolve, 100));
  }
  throw new Error("VS Code does not start");
}

function freePort() {
  return new Promise((resolve, reject) => {
    const probe = createServer();
    probe.on("error", reject);
    probe.listen(0, "127.0.0.1", () => {
      const { port } = probe.address();
      probe.close(() => resolve(port));
    });
  });
}

module.exports = { startVsCode };
