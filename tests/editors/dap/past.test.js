// Reverse execution.
const assert = require("node:assert/strict");
const { after, before, test } = require("node:test");
const { Application } = require("./application");
const { counter } = require("./counter");
const { Session, debug } = require("./session");
const { shapes } = require("./shapes");

let app;
before(() => { app = counter(); });
after(() => app.remove());

/** Debugs the counter at its end. */
async function counted(test, options = {}) {
  const before = (session) => session.setBreakpoints(app.file("start"), app.line("start", "sText="));
  await debug(app.folder(), { before, ...options }, async (session) => {
    await session.stopped("breakpoint");
    await test(session);
  });
}

test("steps back go to the line before, over programs that were called", async () => {
  await counted(async (session) => {
    await session.run("stepBack", "step");
    assert.equal(await session.place(), `start:${app.line("start", "for nIndex")}`);
    await session.run("stepBack", "step");
    assert.equal(await session.place(), `start:${app.line("start", "call tools")}`);
    assert.deepEqual([await session.evaluate("nIndex"), await session.evaluate("nSquare")], ["12", "121"]);
    await session.run("next", "step");
    assert.equal(await session.evaluate("nSquare"), "144");
  });
});

test("steps back lead into the last line of a program that was called, and out to its call", async () => {
  await counted(async (session) => {
    await session.run("stepBack", "step");
    await session.run("stepBack", "step");
    await session.run("next", "step");
    await session.run("val3/stepBackInto", "step");
    assert.match(await session.place(), /^square:/);
    await session.run("val3/stepBackOut", "step");
    assert.equal(await session.place(), `start:${app.line("start", "call tools")}`);
  });
});

test("the history of a variable contains its writes", async () => {
  await counted(async (session) => {
    const [{ id: frameId }] = await session.frames();
    const { writes, more } = await session.ask("val3/history", { name: "nSquare", frameId, count: 2 });
    assert.deepEqual(writes.map(({ value }) => value), ["144", "121"]);
    assert.deepEqual([writes[0].source.program, more], ["square", true]);
    assert.equal(await session.place(), `start:${app.line("start", "sText=")}`);
  });
});

test("a run stops before its end if the client wants to, and goes back from there", async () => {
  await debug(app.folder(), { stopOnExit: true }, async (session) => {
    const stop = await session.stopped("pause");
    assert.equal(stop.description, "Paused before the end of the application");
    assert.equal(await session.place(), `start:${app.line("start", "logMsg") + 1}`);
    await session.run("stepBack", "step");
    await session.run("continue", "pause");
    await session.ask("continue", { threadId: session.thread });
    await session.event("terminated");
  });
});

test("the run goes back to breakpoints, and then to its beginning", async () => {
  await counted(async (session) => {
    await session.setBreakpoints(app.file("add"), { line: app.line("add", "x_nTotal="), condition: "x_nValue==3" });
    const stop = await session.run("reverseContinue", "breakpoint");
    assert.equal(stop.allThreadsStopped, true);
    assert.deepEqual([await session.evaluate("x_nValue"), await session.evaluate("nSum")], ["3", "3"]);
    const beginning = await session.run("reverseContinue", "entry");
    assert.equal(beginning.text, "the run begins here");
    assert.equal(await session.evaluate("nSum"), "0");
    await session.run("continue", "breakpoint");
    assert.equal(await session.evaluate("nSum"), "3");
  });
});

test("a change in the past begins a new future, which the user is told", async () => {
  await counted(async (session) => {
    await session.evaluate("nSum=78", "repl");
    assert.deepEqual(session.arrived("output"), [], "this is the present");
    await session.setBreakpoints(app.file("add"), { line: app.line("add", "x_nTotal="), condition: "x_nValue==12" });
    await session.run("reverseContinue", "breakpoint");
    const { variablesReference } = await session.scope("Locals");
    await session.ask("setVariable", { variablesReference, name: "l_nBefore", value: "1000" });
    assert.match((await session.event("output")).output, /new future begins/);
    await session.run("next", "step");
    await session.run("next", "step");
    assert.equal(await session.evaluate("nSum"), "1012");
    // The run is at its newest moment again, so this change discards no recorded events and causes no note.
    await session.evaluate("nSum=5", "repl");
    assert.deepEqual(session.arrived("output"), []);
  });
});

test("the past is bounded, and its reach is reported", async () => {
  await counted(async (session) => {
    const past = await session.ask("val3/past");
    assert.deepEqual([past.first, past.isWhole], [0, true]);
    assert.equal(past.time, (await session.ask("val3/pose")).t);
    assert.ok(past.snapshots >= 1 && past.bytes > 0 && past.cycles >= 0, JSON.stringify(past));
  });
  const own = new Application("long", {
    data: { "num nRounds": "" },
    programs: `
program start()
begin
  do
    nRounds=nRounds+1
    delay(0.004)
  until nRounds==2000
  nRounds=0
end
`,
  });
  const before = async (session) => {
    await session.setBreakpoints(own.file("start"), own.line("start", "nRounds=0"));
  };
  await debug(own.folder(), { before, pastSnapshots: 3, pastMemory: 1 }, async (session) => {
    await session.stopped("breakpoint");
    const past = await session.ask("val3/past");
    assert.ok(past.snapshots <= 3, JSON.stringify(past));
    assert.ok(past.bytes <= 1 << 20, JSON.stringify(past));
  });
  await debug(own.folder(), { before, noDebug: true }, async (session) => {
    assert.match(await session.refused("val3/past"), /not recorded|over/);
  });
  own.remove();
});

test("settings with wrong values are refused", async () => {
  const session = await Session.start();
  const wrong = { pastMemory: 0, pastSnapshots: "all", angles: "gon", stopScope: "some", motionMode: "slow", stopOnEntry: "yes", variableFilter: "n[" };
  for (const [key, value] of Object.entries(wrong)) {
    const reason = await session.refused("launch", { program: app.folder(), [key]: value });
    assert.match(reason, key === "motionMode" ? /slow/ : new RegExp(key));
  }
  assert.equal(await session.end(), 0);
});

test("angles are shown in radians if the client wants to", async () => {
  const own = shapes();
  const before = (session) => session.setBreakpoints(own.file("show"), own.line("show", "bFlag="));
  await debug(own.folder(), { before, angles: "radians" }, async (session) => {
    await session.stopped("breakpoint");
    const at = await session.variable("Locals", "l_trAt");
    const rz = (await session.inside(at)).find(({ name }) => name === "rz");
    assert.match(rz.value, /^1\.5707963.* rad$/);
    const joints = await session.inside(await session.variable("Globals", "jHome"));
    assert.match(joints.find(({ name }) => name === "j2").value, /^-0\.349.* rad$/);
  });
  own.remove();
});

test("a long search shows its progress, and is cancelled", async () => {
  const own = new Application("endless", {
    data: { "num nRound": "" },
    programs: `
program start()
begin
  while true
    nRound=nRound+1
    delay(0.004)
  endWhile
end`,
  });
  const client = { supportsProgressReporting: true };
  await debug(own.folder(), { client, stopOnEntry: true }, async (session) => {
    await session.stopped("entry");
    await session.ask("continue", { threadId: session.thread });
    await new Promise((resolve) => setTimeout(resolve, 2000));
    await session.ask("pause", { threadId: session.thread });
    await session.stopped("pause");
    const rounds = await session.evaluate("nRound");
    // The response does not wait for the search.
    await session.ask("reverseContinue", { threadId: session.thread });
    const { progressId, cancellable } = await session.event("progressStart");
    assert.equal(cancellable, true);
    await session.ask("cancel", { progressId });
    assert.equal((await session.stopped("pause")).text, "the search was cancelled");
    assert.equal((await session.event("progressEnd")).progressId, progressId);
    assert.equal(await session.evaluate("nRound"), rounds, "the run is where it was");
  });
  own.remove();
});

test("the hits of a breakpoint go back with the run", async () => {
  const line = app.line("add", "x_nTotal=");
  const before = (session) => session.setBreakpoints(app.file("add"), line);
  await debug(app.folder(), { before }, async (session) => {
    await session.stopped("breakpoint");
    await session.run("continue", "breakpoint");
    await session.run("continue", "breakpoint");
    const hits = async () => {
      const changes = session.arrived("breakpoint").map(({ breakpoint }) => breakpoint.message);
      return [changes.at(-1), await session.evaluate("x_nValue")];
    };
    assert.deepEqual(await hits(), ["hit 3 times", "3"]);
    await session.run("reverseContinue", "breakpoint");
    assert.deepEqual(await hits(), ["hit 2 times", "2"]);
    await session.run("stepBack", "step");
    assert.deepEqual(await hits(), ["hit once", "2"]);
    await session.run("continue", "breakpoint");
    assert.deepEqual(await hits(), ["hit 2 times", "2"]);
  });
});

test("a watched local ends with its program, and is watched again after a step back", async () => {
  const before = (session) => session.setBreakpoints(app.file("add"), app.line("add", "l_nBefore="));
  await debug(app.folder(), { before }, async (session) => {
    await session.stopped("breakpoint");
    const [, { id }] = await session.watchData("l_nBefore");
    await session.setBreakpoints(app.file("add"));
    await session.setBreakpoints(app.file("start"), app.line("start", "nMany["));
    const changed = async (verified) => {
      const { breakpoint } = await session.eventWhere("breakpoint", ({ breakpoint }) => breakpoint.id === id && breakpoint.verified === verified);
      return breakpoint.message;
    };
    await session.run("continue", "breakpoint");
    assert.match(await changed(false), /the program of this variable has ended/);
    await session.run("val3/stepBackInto", "step");
    assert.match(await session.place(), /^add:/);
    await changed(true);
    await session.run("continue", "breakpoint");
    assert.match(await changed(false), /the program of this variable has ended/);
    // A later call has a variable of its own.
    await session.run("continue", "breakpoint");
  });
});
