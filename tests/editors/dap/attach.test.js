// Clients that attach to runs, and sessions over ports.
const assert = require("node:assert/strict");
const { spawn } = require("node:child_process");
const { once } = require("node:events");
const { join } = require("node:path");
const { createInterface } = require("node:readline");
const test = require("node:test");
const { Session } = require("./session");

const EXAMPLE = join(process.env.VAL3_ROOT, "examples/palletiser");
const PALLETISER = join(EXAMPLE, "usr/usrapp/palletiser");

/** Starts a process that first prints its port and secret, and ends it after the test. */
async function listening(args, test) {
  const process_ = spawn(process.env.VAL3_SERVER, args, { stdio: ["ignore", "ignore", "pipe"] });
  try {
    const [line] = await once(createInterface({ input: process_.stderr }), "line");
    const [, port, secret] = /:(\d+) with the secret (\w+)$/.exec(line);
    await test({ port: Number(port), secret }, process_);
  } finally {
    process_.kill();
  }
}

const run = ["run", PALLETISER, "--script", join(EXAMPLE, "boxes.toml"), "--time", "real", "--debug-port", "0"];

/** Attaches and stops the run. */
async function attach({ port, secret }, options = {}) {
  const session = await Session.start({}, port);
  await session.ask("attach", { stopOnEntry: true, secret, ...options });
  const { capabilities } = await session.event("capabilities");
  assert.equal(capabilities.supportTerminateDebuggee && capabilities.supportSuspendDebuggee, true);
  await session.event("initialized");
  await session.ask("configurationDone");
  assert.equal((await session.event("process")).startMethod, "attach");
  await session.stopped("pause");
  return session;
}

test("clients attach to a run, leave it going or stopped, and end it", async () => {
  await listening(run, async (address, runs) => {
    const first = await attach(address);
    await first.run("next", "step");
    // The run was interrupted at any line, so it may have reached more lines since.
    let back = { reason: "step" };
    while (back.reason === "step") {
      await first.ask("stepBack", { threadId: first.thread });
      back = await first.event("stopped");
    }
    assert.equal(back.reason, "entry");
    assert.match(back.text, /where the debugger has attached/);
    await first.ask("disconnect", { suspendDebuggee: true });
    const second = await attach(address, { stopOnEntry: false });
    assert.match(await second.refused("restart"), /attached/);
    await second.ask("disconnect");
    assert.equal(runs.exitCode, null);
    const third = await attach(address, { motionMode: "step" });
    assert.equal((await third.ask("val3/motionMode")).mode, "step");
    const end = once(runs, "exit");
    await third.ask("disconnect", { terminateDebuggee: true });
    assert.deepEqual(await end, [0, null]);
  });
});

test("an adapter that the client has started passes the session on", async () => {
  await listening(run, async ({ port, secret }) => {
    const session = await Session.start();
    assert.match(await session.refused("attach", { port: 1 }), /--debug-port 1/);
    assert.match(await session.refused("attach", { port }), /`secret` is missing/);
    await session.ask("attach", { port, secret, stopOnEntry: true });
    await session.event("initialized");
    await session.ask("configurationDone");
    await session.stopped("pause");
    assert.notDeepEqual(await session.frames(), []);
    assert.equal(await session.end(), 0);
  });
});

test("a port serves several sessions", async () => {
  await listening(["dap", "--port", "0"], async ({ port, secret }) => {
    const sessions = await Promise.all([0, 1].map(() => Session.start({}, port)));
    for (const session of sessions) {
      assert.match(await session.refused("launch", { program: PALLETISER, secret: "0" }), /`secret` is another one/);
      await session.ask("launch", { program: PALLETISER, stopOnEntry: true, secret });
      await session.ask("configurationDone");
      await session.stopped("entry");
    }
    const [first, second] = sessions;
    await first.run("next", "step");
    assert.notEqual(await first.place(), await second.place());
    await first.ask("disconnect");
    await second.run("next", "step");
    await second.ask("disconnect");
  });
});
