// Breakpoints on lines and programs.
const assert = require("node:assert/strict");
const { mkdirSync, symlinkSync } = require("node:fs");
const { join, relative } = require("node:path");
const { pathToFileURL } = require("node:url");
const { after, before, test } = require("node:test");
const { DebugClient } = require("@vscode/debugadapter-testsupport");
const { Application } = require("./application");
const { counter } = require("./counter");
const { debug } = require("./session");

let app;
before(() => { app = counter(); });
after(() => app.remove());

/** Returns the values of an expression at each stop until the end of the run. */
async function valuesAtStops(session, expression) {
  const values = [];
  const ended = session.event("terminated").then(() => undefined);
  for (;;) {
    const stop = await Promise.race([session.event("stopped"), ended]);
    if (stop === undefined) return values;
    assert.equal(stop.reason, "breakpoint");
    session.thread = stop.threadId;
    values.push(await session.evaluate(expression));
    await session.ask("continue", { threadId: session.thread });
  }
}

test("a breakpoint moves to the next line with an instruction, and the run stops there", async () => {
  const [comment, loop] = [app.line("start", "// Rounds"), app.line("start", "for nIndex")];
  let placed;
  const before = async (session) => {
    placed = await session.setBreakpoints(app.file("start"), comment, app.line("start", "]]>") + 1);
  };
  await debug(app.folder(), { before }, async (session) => {
    const [moved, none] = placed;
    assert.deepEqual([moved.verified, moved.line, moved.source.path], [true, loop, app.file("start")]);
    assert.equal(none.verified, false);
    assert.match(none.message, /no instruction follows/);
    const stop = await session.stopped("breakpoint");
    assert.deepEqual(stop.hitBreakpointIds, [moved.id]);
    assert.equal(stop.allThreadsStopped, true);
    assert.equal(await session.place(), `start:${loop}`);
  });
});

test("the client's own check of a breakpoint passes", async () => {
  const [line, path] = [app.line("start", "call add"), app.file("start")];
  const client = new DebugClient(process.env.VAL3_SERVER, "dap", "val3");
  await client.start();
  await client.hitBreakpoint({ program: app.folder() }, { path, line });
  await client.stop();
});

test("lines of the file count, not those of the code", async () => {
  await debug(app.folder(), { stopOnEntry: true }, async (session) => {
    await session.stopped("entry");
    const begin = app.line("start", "begin");
    const [{ line }] = await session.setBreakpoints(app.file("start"), 1);
    assert.equal(line, begin + 1);
    const [{ breakpoints }] = [await session.ask("breakpointLocations", {
      source: { path: app.file("start") }, line: begin, endLine: app.line("start", "call add"),
    })];
    const rows = ["nSum=0", "for nIndex", "call add"].map((text) => app.line("start", text));
    assert.deepEqual(breakpoints.map((location) => location.line), rows);
  });
});

test("the ends of blocks and programs have breakpoints", async () => {
  const own = new Application("blocks", {
    data: { "num nA": "", "num nB": "" },
    programs: `
program start()
begin
  for nA=1 to 3
    switch nA
      case 2
        nB=1
      break
      default
        nB=2
      break
    endSwitch
  endFor
  while nA<6
    nA=nA+1
  endWhile
end
`,
  });
  const lines = ["break", "endFor", "endWhile", "]]>"].map((text) => own.line("start", text));
  let placed;
  const before = async (session) => (placed = await session.setBreakpoints(own.file("start"), ...lines));
  await debug(own.folder(), { before }, async (session) => {
    assert.deepEqual(placed.map(({ line, verified }) => [line, verified]), lines.map((line) => [line, true]));
    const [first, , , last] = lines;
    const { breakpoints } = await session.ask("breakpointLocations", { source: { path: own.file("start") }, line: first, endLine: last });
    const possible = breakpoints.map(({ line }) => line);
    assert.ok(lines.every((line) => possible.includes(line)), `${possible}`);
    const stops = [];
    for (let count = 0; count < 7; count += 1) {
      await session.stopped("breakpoint");
      stops.push(Number((await session.place()).split(":")[1]));
      if (stops.length < 7) await session.ask("continue", { threadId: session.thread });
    }
    const [stop, round, repeated, end] = lines;
    assert.deepEqual(stops, [round, stop, round, round, repeated, repeated, end]);
    assert.equal(await session.evaluate("nA"), "6", "the last state of the program");
  });
  own.remove();
});

test("a breakpoint may be for one task", async () => {
  const own = new Application("pair", {
    programs: `
program start()
begin
  taskCreate "one",10,work()
  taskCreate "two",10,work()
end
program work()
begin
  delay(0)
end
`,
  });
  const before = (session) => session.setBreakpoints(own.file("work"), { line: own.line("work", "delay"), condition: "task==\"two\"" });
  await debug(own.folder(), { before }, async (session) => {
    const { threadId } = await session.stopped("breakpoint");
    const { threads } = await session.ask("threads");
    assert.match(threads.find(({ id }) => id === threadId).name, /two/);
    await session.ask("continue", { threadId });
    await session.event("terminated");
    assert.deepEqual(session.arrived("stopped"), []);
  });
  own.remove();
});

test("a condition lets the run stop only where it holds", async () => {
  const line = app.line("add", "l_nBefore=");
  const before = (session) => session.setBreakpoints(app.file("add"), { line, condition: "x_nValue==7 or nIndex>11" });
  await debug(app.folder(), { before }, async (session) => {
    assert.deepEqual(await valuesAtStops(session, "x_nValue"), ["7", "12"]);
  });
});

test("a wrong condition is refused", async () => {
  await debug(app.folder(), { stopOnEntry: true }, async (session) => {
    await session.stopped("entry");
    const line = app.line("add", "l_nBefore=");
    const wrong = [{ line, condition: "x_nValue=" }, { line, condition: "x_nValue+1" }, { line, hitCondition: "often" }];
    for (const breakpoint of wrong) {
      const [{ verified, message }] = await session.setBreakpoints(app.file("add"), breakpoint);
      assert.equal(verified, false);
      assert.ok(message.length > 10, message);
    }
  });
});

test("a condition that fails stops the run and says why", async () => {
  const line = app.line("add", "l_nBefore=");
  const before = (session) => session.setBreakpoints(app.file("add"), { line, condition: "nMany[x_nValue+19]==0" });
  await debug(app.folder(), { before }, async (session) => {
    const stop = await session.stopped("breakpoint");
    assert.match(stop.text, /condition cannot be evaluated/);
  });
});

for (const [hitCondition, expected] of [["5", ["5"]], [">=10", ["10", "11", "12"]], [">10", ["11", "12"]], ["<3", ["1", "2"]], ["<=2", ["1", "2"]], ["%5", ["5", "10"]]]) {
  test(`the number of hits ${hitCondition}`, async () => {
    const line = app.line("add", "l_nBefore=");
    const before = (session) => session.setBreakpoints(app.file("add"), { line, hitCondition });
    await debug(app.folder(), { before }, async (session) => {
      assert.deepEqual(await valuesAtStops(session, "x_nValue"), expected);
    });
  });
}

/** Returns the shortest time, in ms, of three runs of an application with this breakpoint, which never stops them. */
async function runTime(own, breakpoint) {
  const times = [];
  for (let run = 0; run < 3; run += 1) {
    const before = (session) => (breakpoint === undefined ? session.setBreakpoints(own.file("start")) : session.setBreakpoints(own.file("start"), breakpoint));
    await debug(own.folder(), { before, stopOnEntry: true }, async (session) => {
      await session.stopped("entry");
      const start = performance.now();
      await session.ask("continue", { threadId: session.thread });
      await session.event("terminated");
      times.push(performance.now() - start);
      assert.deepEqual(session.arrived("stopped"), []);
    });
  }
  return Math.min(...times);
}

test("breakpoints that do not stop hardly slow down a loop", async () => {
  const own = new Application("fast", {
    data: { "num nRound": "", "num nSum": "" },
    programs: "\nprogram start()\nbegin\n  for nRound=1 to 40000\n    nSum=nSum+nRound\n    nSum=nSum/2\n  endFor\nend\n",
  });
  try {
    const line = own.line("start", "nSum=nSum+");
    const plain = await runTime(own);
    for (const rule of [{ condition: "nRound<0" }, { hitCondition: "300000" }, { condition: "nRound>5", hitCondition: "%500000" }]) {
      const factor = (await runTime(own, { line, ...rule })) / plain;
      // A stop of the interpreter at each hit costs more than ten times the plain run.
      assert.ok(factor < 6, `${JSON.stringify(rule)}: ${factor.toFixed(1)} times the plain run`);
    }
  } finally {
    own.remove();
  }
});

test("hits count where the condition holds, and breakpoints that stay keep them", async () => {
  const line = app.line("add", "l_nBefore=");
  const wanted = { line, condition: "x_nValue>3", hitCondition: "%2" };
  const before = (session) => session.setBreakpoints(app.file("add"), wanted);
  await debug(app.folder(), { before }, async (session) => {
    await session.stopped("breakpoint");
    assert.equal(await session.evaluate("x_nValue"), "5");
    await session.setBreakpoints(app.file("add"), wanted, app.line("add", "x_nTotal="));
    await session.run("continue", "breakpoint");
    await session.setBreakpoints(app.file("add"), wanted);
    await session.run("continue", "breakpoint");
    assert.equal(await session.evaluate("x_nValue"), "7");
  });
});

test("a log point writes its message and does not stop the run", async () => {
  const line = app.line("add", "x_nTotal=");
  const logMessage = "add {x_nValue} to {l_nBefore}, {sText}";
  const before = (session) => session.setBreakpoints(app.file("add"), { line, logMessage, condition: "x_nValue<=2" });
  await debug(app.folder(), { before }, async (session) => {
    await session.event("terminated");
    assert.deepEqual(session.arrived("stopped"), []);
    const logged = session.arrived("output").filter(({ output }) => output.startsWith("add "));
    assert.deepEqual(logged.map(({ output }) => output), ["add 1 to 0, none\n", "add 2 to 1, none\n"]);
  });
});

test("programs have breakpoints by their names, those of libraries too", async () => {
  let placed;
  const before = async (session) => {
    const breakpoints = [
      { name: "add", condition: "x_nValue==2" }, { name: "tools:square", hitCondition: ">=11" },
      { name: "other:square" }, { name: "add", condition: "nothing==2" },
    ];
    placed = (await session.ask("setFunctionBreakpoints", { breakpoints })).breakpoints;
  };
  await debug(app.folder(), { before }, async (session) => {
    const [add, square, other, wrong] = placed;
    assert.deepEqual([add.verified, add.line], [true, app.line("add", "l_nBefore=")]);
    assert.deepEqual([square.verified, square.source.path], [true, app.file("square", "tools")]);
    assert.equal(other.verified, false);
    assert.match(wrong.message, /nothing/);
    assert.deepEqual((await session.stopped("breakpoint")).hitBreakpointIds, [add.id]);
    assert.equal(await session.evaluate("x_nValue"), "2");
    assert.deepEqual((await session.run("continue", "breakpoint")).hitBreakpointIds, [square.id]);
    assert.equal(await session.evaluate("nCalls"), "10");
    const names = (await session.frames()).map(({ name }) => name);
    assert.deepEqual(names, ["tools:square()", "counter:start()"]);
    await session.ask("setFunctionBreakpoints", { breakpoints: [] });
    await session.ask("continue", { threadId: session.thread });
    await session.event("terminated");
    assert.deepEqual(session.arrived("stopped"), []);
  });
});

test("after a change of the source and a restart, breakpoints are at their lines of the new file", async () => {
  const own = counter();
  const line = own.line("start", "call add");
  const before = (session) => session.setBreakpoints(own.file("start"), line);
  await debug(own.folder(), { before }, async (session) => {
    await session.stopped("breakpoint");
    own.edit("start", "    call add", "    // A new line\n    nSum=nSum+100\n    call add");
    await session.ask("restart");
    const changed = await session.eventWhere("breakpoint", ({ breakpoint }) => breakpoint.line === line + 1);
    assert.equal(changed.breakpoint.verified, true);
    await session.stopped("breakpoint");
    assert.equal(await session.place(), `start:${line + 1}`);
    // Clients move a breakpoint together with its line.
    const [moved] = await session.setBreakpoints(own.file("start"), own.line("start", "call add"));
    assert.equal(moved.line, line + 2);
    await session.run("continue", "breakpoint");
    assert.equal(await session.evaluate("nSum"), "100");
  });
  own.remove();
});

test("breakpoints change while the program runs", async () => {
  const endless = new Application("endless", {
    data: { "num nRounds": "" },
    programs: `
program start()
begin
  while true
    nRounds=nRounds+1
    delay(0.004)
  endWhile
end
`,
  });
  await debug(endless.folder(), { time: "real" }, async (session) => {
    const [placed] = await session.setBreakpoints(endless.file("start"), endless.line("start", "nRounds="));
    assert.equal(placed.verified, true);
    await session.stopped("breakpoint");
    await session.run("continue", "breakpoint");
    await session.ask("continue", { threadId: session.thread });
    assert.deepEqual(await session.setBreakpoints(endless.file("start")), []);
    await session.ask("pause", { threadId: session.thread });
    // The run may have been at the breakpoint once more before it was removed.
    const { reason, threadId } = await session.event("stopped");
    if (reason === "breakpoint") {
      session.thread = threadId;
      await session.ask("continue", { threadId });
      // A stopped run is not paused.
      await session.run("pause", "pause");
    }
  });
  endless.remove();
});

test("a file is found by other forms of its path", async () => {
  const line = app.line("start", "call add");
  const link = join(app.cell, "link");
  symlinkSync(app.folder(), link);
  mkdirSync(join(app.cell, "other"));
  const around = join(app.cell, "other") + "/" + relative(join(app.cell, "other"), app.file("start"));
  for (const path of [join(link, "start.pgx"), around, pathToFileURL(app.file("start")).href]) {
    const before = async (session) => {
      assert.equal((await session.setBreakpoints(path, line))[0].verified, true, path);
    };
    await debug(app.folder(), { before }, (session) => session.stopped("breakpoint"));
  }
  // The application is opened by its other path.
  const before = (session) => session.setBreakpoints(app.file("start"), line);
  await debug(link, { before }, (session) => session.stopped("breakpoint"));
});

test("a client may count lines from 0 and name files by URIs", async () => {
  const client = { linesStartAt1: false, columnsStartAt1: false, pathFormat: "uri" };
  const path = pathToFileURL(app.file("start")).href;
  const line = app.line("start", "call add") - 1;
  const before = (session) => session.setBreakpoints(path, line);
  await debug(app.folder(), { before, client }, async (session) => {
    await session.stopped("breakpoint");
    const [frame] = await session.frames();
    assert.deepEqual([frame.line, frame.column, frame.source.path], [line, 4, path], "the line begins with four blanks");
  });
});
