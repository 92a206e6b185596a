// Stops, steps and the tasks of a run.
const assert = require("node:assert/strict");
const { once } = require("node:events");
const { connect, createServer } = require("node:net");
const { join } = require("node:path");
const { after, before, test } = require("node:test");
const { Application } = require("./application");
const { counter } = require("./counter");
const { Session, debug } = require("./session");

const PALLETISER = join(process.env.VAL3_ROOT, "examples/palletiser/usr/usrapp/palletiser");

/** Two tasks that count, a synchronous task, and a task that fails. */
const tasks = () => new Application("tasks", {
  data: { "num nFirst": "", "num nSecond": "", "num nTicks": "", "num nZero": "", "num nCodes[4]": "", "bool bOverrun": "" },
  programs: `
program start()
begin
  taskCreate "first",10,first()
  taskCreate "second",20,second()
  taskCreateSync "ticks",0.02,bOverrun,ticks()
end
program first()
begin
  while true
    nFirst=nFirst+1
    delay(0.01)
  endWhile
end
program second()
begin
  while true
    nSecond=nSecond+1
    delay(0.01)
  endWhile
end
program ticks()
begin
  while true
    nTicks=nTicks+1
    delay(0)
  endWhile
end
`,
});

/** Run-time errors: one that another task handles, and one that no task handles. */
const failing = () => new Application("failing", {
  data: { "num nCodes[4]": "", "num nIndex": "" },
  programs: `
program start()
begin
  taskCreate "watched",10,outside()
  delay(0.1)
  nCodes[0]=taskStatus("watched")
  taskKill("watched")
  call outside()
end
program outside()
begin
  nIndex=9
  nCodes[nIndex]=1
end
`,
});

let app;
before(() => { app = tasks(); });
after(() => app.remove());

/** Returns the names of the tasks, and their numbers by name. */
async function threads(session) {
  const { threads } = await session.ask("threads");
  return threads.map(({ id, name }) => ({ id, name: name.split(" (")[0], more: name }));
}

async function threadOf(session, name) {
  return (await threads(session)).find((thread) => thread.name === name).id;
}

test("the adapter announces what the tests try", async () => {
  const session = await Session.start();
  const { exceptionBreakpointFilters: filters, completionTriggerCharacters, ...rest } = session.capabilities;
  assert.deepEqual(filters.map(({ filter }) => filter), ["all", "unhandled", "assertion", "motion", "contacts", "codes"]);
  assert.deepEqual(completionTriggerCharacters, [".", ":"]);
  assert.deepEqual(Object.keys(rest).filter((name) => rest[name] === true).sort(), [
    "supportsANSIStyling", "supportsBreakpointLocationsRequest", "supportsCancelRequest", "supportsClipboardContext", "supportsCompletionsRequest",
    "supportsConditionalBreakpoints", "supportsConfigurationDoneRequest", "supportsDataBreakpoints",
    "supportsDelayedStackTraceLoading", "supportsEvaluateForHovers", "supportsExceptionFilterOptions",
    "supportsExceptionInfoRequest", "supportsFunctionBreakpoints", "supportsGotoTargetsRequest",
    "supportsHitConditionalBreakpoints", "supportsLoadedSourcesRequest", "supportsLogPoints", "supportsModulesRequest",
    "supportsRestartFrame", "supportsRestartRequest", "supportsSetExpression", "supportsSetVariable",
    "supportsSingleThreadExecutionRequests", "supportsStepBack", "supportsStepInTargetsRequest",
    "supportsSteppingGranularity", "supportsTerminateRequest", "supportsTerminateThreadsRequest",
    "supportsValueFormattingOptions",
  ]);
  assert.equal(await session.end(), 0);
});

test("tasks are threads with priority or period, and come and go", async () => {
  await debug(app.folder(), { stopOnEntry: true }, async (session) => {
    await session.stopped("entry");
    assert.deepEqual((await session.arrived("thread")).map(({ reason }) => reason), ["started"]);
    await session.setBreakpoints(app.file("ticks"), { line: app.line("ticks", "nTicks="), hitCondition: "3" });
    await session.run("continue", "breakpoint");
    const shown = (await threads(session)).map(({ more }) => more);
    assert.deepEqual(shown.map((name) => name.replace(/, waits for .*\)/, ", waits)")), [
      "first (priority 10, waits)", "second (priority 20, waits)", "ticks (every 20 ms)",
    ]);
    assert.equal(session.arrived("thread").filter(({ reason }) => reason === "started").length, 3);
    await session.ask("setBreakpoints", { source: { path: app.file("ticks") }, breakpoints: [] });
    const first = await threadOf(session, "first");
    await session.ask("terminateThreads", { threadIds: [first] });
    assert.equal((await session.eventWhere("thread", ({ threadId }) => threadId === first)).reason, "exited");
    assert.deepEqual((await threads(session)).map(({ name }) => name), ["second", "ticks"]);
    assert.match(await session.refused("stackTrace", { threadId: first }), /no such task/);
  });
});

test("steps over, into and out of a program, for lines and statements", async () => {
  const own = counter();
  const line = (text) => `start:${own.line("start", text)}`;
  await debug(own.folder(), { stopOnEntry: true }, async (session) => {
    await session.stopped("entry");
    const step = async (command, granularity) => {
      await session.run(command, "step", { granularity });
      return session.place();
    };
    assert.equal(await session.place(), line("nSum=0"));
    assert.equal(await step("next"), line("for nIndex"));
    assert.equal(await step("next", "line"), line("call add"));
    assert.equal(await step("stepIn", "statement"), `add:${own.line("add", "l_nBefore=")}`);
    assert.equal(await step("stepOut"), line("nMany["));
    assert.equal(await step("next"), line("call tools"));
    assert.equal(await step("next"), line("for nIndex"));
  }).finally(() => own.remove());
});

test("a step goes into the program or task that was chosen", async () => {
  await debug(app.folder(), { stopOnEntry: true }, async (session) => {
    await session.stopped("entry");
    const [{ id: frameId }] = await session.frames();
    const { targets } = await session.ask("stepInTargets", { frameId });
    assert.deepEqual(targets.map(({ label }) => label), ["the task of tasks:first()"]);
    const main = session.thread;
    await session.run("stepIn", "step", { targetId: targets[0].id });
    assert.notEqual(session.thread, main);
    assert.equal(await session.place(), `first:${app.line("first", "while true")}`);
    const [{ id: inside }] = await session.frames();
    assert.deepEqual((await session.ask("stepInTargets", { frameId: inside })).targets, []);
  });
});

test("errors of an application have colours for a client that shows them", async () => {
  const own = counter();
  own.edit("start", "nSum=0", "nSum=nothing");
  for (const supportsANSIStyling of [true, false]) {
    const session = await Session.start({ supportsANSIStyling });
    assert.match(await session.refused("launch", { program: own.folder() }), /has errors/);
    const said = session.arrived("output").map(({ output }) => output).join("");
    assert.match(said, /nothing/);
    assert.equal(said.includes("\u001b["), supportsANSIStyling);
    assert.equal(await session.end(), 0);
  }
  own.remove();
});

test("an expression for the clipboard is the whole value", async () => {
  const own = counter();
  const before = (session) => session.setBreakpoints(own.file("start"), own.line("start", "sText="));
  await debug(own.folder(), { before }, async (session) => {
    await session.stopped("breakpoint");
    const sums = [0, 1, 3, 6, 10, 15, 21, 28, 36, 45, 55, 66, 78, 0, 0, 0, 0, 0, 0, 0];
    assert.equal(await session.evaluate("nMany", "clipboard"), `{${sums.join(", ")}}`);
    assert.equal(await session.evaluate("nMany"), "20 values");
  });
  own.remove();
});

test("when all tasks are stopped, time stands still", async () => {
  await debug(app.folder(), { time: "real" }, async (session) => {
    await session.event("thread");
    await session.ask("pause", { threadId: 1 });
    const stop = await session.stopped("pause");
    assert.equal(stop.allThreadsStopped, true);
    const seen = async () => [(await session.ask("val3/pose")).t, await session.evaluate("nTicks")];
    const before = await seen();
    await new Promise((resolve) => { setTimeout(resolve, 50); });
    assert.deepEqual(await seen(), before);
  });
});

test("a single task runs while the others are held", async () => {
  await debug(app.folder(), { stopOnEntry: true }, async (session) => {
    await session.stopped("entry");
    const [path, line] = [app.file("first"), app.line("first", "nFirst=")];
    await session.setBreakpoints(path, line);
    await session.run("continue", "breakpoint");
    await session.run("continue", "breakpoint");
    const other = await session.evaluate("nSecond");
    for (let round = 0; round < 5; round += 1) {
      await session.ask("continue", { threadId: session.thread, singleThread: true });
      await session.stopped("breakpoint");
    }
    assert.equal(await session.evaluate("nSecond"), other);
    assert.match((await threads(session)).find(({ name }) => name === "second").more, /held by the debugger/);
    await session.run("next", "step", { singleThread: true });
    assert.equal(await session.evaluate("nSecond"), other);
    await session.run("continue", "breakpoint");
    await session.run("continue", "breakpoint");
    assert.notEqual(await session.evaluate("nSecond"), other);
  });
});

/** Returns the locations at which errors stop a run with these filters. */
async function errors(filters, filterOptions = []) {
  const own = failing();
  const places = [];
  const before = (session) => session.ask("setExceptionBreakpoints", { filters, filterOptions });
  await debug(own.folder(), { before }, async (session) => {
    const ended = Promise.race([session.event("terminated"), session.event("exited")]).then(() => undefined);
    for (;;) {
      const stop = await Promise.race([session.event("stopped"), ended]);
      if (stop === undefined) break;
      assert.equal(stop.reason, "exception");
      places.push((await threads(session)).find(({ id }) => id === stop.threadId).name);
      await session.ask("continue", { threadId: stop.threadId });
      if (places.length === 2) break;
    }
  });
  own.remove();
  return places;
}

test("run-time errors stop the run as the filters say", async () => {
  assert.deepEqual(await errors(["all"]), ["watched", "failing~"]);
  assert.deepEqual(await errors(["unhandled"]), ["failing~"]);
  assert.deepEqual(await errors(["motion"]), []);
  assert.deepEqual(await errors([], [{ filterId: "codes", condition: "20" }]), ["watched", "failing~"]);
  assert.deepEqual(await errors([], [{ filterId: "codes", condition: "10, 21" }]), []);
  assert.deepEqual(await errors([]), []);
});

test("an error of a move stops the run as an error of the motion", async () => {
  const own = new Application("moving", {
    data: { "joint jFar": `j1="1000"`, "mdesc mNom": "", "num nZero": "" },
    programs: `
program start()
begin
  taskCreate "other",10,other()
  delay(0.1)
  movej(jFar,flange,mNom)
end
program other()
begin
  nZero=1/nZero
end`,
  });
  const before = (session) => session.ask("setExceptionBreakpoints", { filters: ["motion"] });
  await debug(own.folder(), { before, arm: "tx60l", power: true }, async (session) => {
    await session.stopped("exception");
    assert.equal(await session.place(), `start:${own.line("start", "movej")}`);
  });
  own.remove();
});

test("an error has a page, and a wrong filter is refused", async () => {
  const own = failing();
  const before = (session) => session.ask("setExceptionBreakpoints", { filters: ["all"] });
  await debug(own.folder(), { before }, async (session) => {
    const stop = await session.stopped("exception");
    assert.match(stop.text, /^error 20: /);
    const info = await session.ask("exceptionInfo", { threadId: stop.threadId });
    assert.equal(info.exceptionId, "error 20");
    assert.match(info.description, /val3 explain 20/);
    assert.equal(info.details.typeName, "20");
    assert.match((await threads(session)).find(({ id }) => id === stop.threadId).more, /error 20: /);
    const main = await threadOf(session, "failing~");
    assert.match(await session.refused("exceptionInfo", { threadId: main }), /no run-time error/);
    const filterOptions = [{ filterId: "codes", condition: "many" }];
    const { breakpoints } = await session.ask("setExceptionBreakpoints", { filters: ["loud"], filterOptions });
    assert.deepEqual(breakpoints.map(({ verified }) => verified), [false, false]);
    assert.match(breakpoints[1].message, /many/);
  });
  own.remove();
});

test("a task goes to another line of its program", async () => {
  const own = counter();
  const path = own.file("start");
  await debug(own.folder(), { stopOnEntry: true }, async (session) => {
    await session.stopped("entry");
    const line = own.line("start", "sText=");
    const { targets } = await session.ask("gotoTargets", { source: { path }, line });
    assert.deepEqual(targets.map((target) => target.line), [line]);
    await session.ask("goto", { threadId: session.thread, targetId: targets[0].id });
    await session.stopped("goto");
    assert.equal(await session.place(), `start:${line}`);
    await session.run("next", "step");
    assert.deepEqual([await session.evaluate("sText"), await session.evaluate("nSum")], ["\"done\"", "0"]);
    const other = await session.ask("gotoTargets", { source: { path: own.file("add") }, line: own.line("add", "x_nTotal=") });
    assert.deepEqual(other.targets, [], "no task is in this program");
    assert.match(await session.refused("goto", { threadId: session.thread, targetId: 77 }), /over/);
  });
  own.remove();
});

test("a frame starts again", async () => {
  const own = counter();
  const before = (session) => session.setBreakpoints(own.file("add"), { line: own.line("add", "x_nTotal="), hitCondition: "3" });
  await debug(own.folder(), { before }, async (session) => {
    await session.stopped("breakpoint");
    const [inner, outer] = await session.frames();
    await session.ask("restartFrame", { frameId: inner.id });
    await session.stopped("restart");
    assert.equal(await session.place(), `add:${own.line("add", "l_nBefore=")}`);
    assert.equal(await session.evaluate("nIndex"), "3");
    await session.ask("restartFrame", { frameId: (await session.frames())[1].id });
    await session.stopped("restart");
    assert.equal(await session.place(), `start:${own.line("start", "nSum=0")}`);
    assert.equal(outer.canRestart, true);
  });
  own.remove();
});

test("a run starts again from its first line", async () => {
  const own = counter();
  await debug(own.folder(), { stopOnEntry: true }, async (session) => {
    await session.stopped("entry");
    await session.run("next", "step");
    await session.ask("restart");
    await session.stopped("entry");
    assert.equal(await session.place(), `start:${own.line("start", "nSum=0")}`);
    await session.ask("continue", { threadId: session.thread });
    assert.equal((await session.event("exited")).exitCode, 0);
    await session.event("terminated");
    await session.ask("restart");
    await session.stopped("entry");
  });
  own.remove();
});

test("sources and modules", async () => {
  await debug(PALLETISER, { stopOnEntry: true }, async (session) => {
    await session.stopped("entry");
    const { sources } = await session.ask("loadedSources");
    const names = sources.map(({ name }) => name);
    assert.ok(names.includes("pick.pgx") && !names.includes("grip.pgx"), `${names}`);
    const { modules, totalModules } = await session.ask("modules");
    assert.deepEqual([modules.map(({ name }) => name), totalModules], [["palletiser", "io"], 2]);
    const { modules: page } = await session.ask("modules", { startModule: 1, moduleCount: 1 });
    assert.deepEqual(page.map(({ name }) => name), ["io"]);
    session.arrived("module");
    // A library that is loaded while the program runs.
    await session.evaluate("part:libLoad(\"partBox\")", "repl");
    assert.equal((await session.event("module")).module.name, "partBox");
    const { source } = await session.eventWhere("loadedSource", ({ source }) => source.name === "grip.pgx");
    const [{ verified }] = await session.setBreakpoints(source.path, 8);
    assert.equal(verified, true);
  });
});

test("a breakpoint in a library that the console loads is verified", async () => {
  await debug(PALLETISER, { stopOnEntry: true }, async (session) => {
    await session.stopped("entry");
    const [before] = (await session.ask("setFunctionBreakpoints", { breakpoints: [{ name: "grip" }] })).breakpoints;
    assert.deepEqual([before.verified, before.reason], [false, "pending"]);
    await session.evaluate("part:libLoad(\"partBox\")", "repl");
    const { breakpoint } = await session.eventWhere("breakpoint", ({ breakpoint }) => breakpoint.id === before.id);
    assert.deepEqual([breakpoint.verified, breakpoint.source.name], [true, "grip.pgx"]);
  });
});

test("a run ends as an operator ends it", async () => {
  await debug(PALLETISER, { stopOnEntry: true }, async (session) => {
    await session.stopped("entry");
    await session.ask("terminate");
    assert.equal((await session.event("exited")).exitCode, 0);
    await session.event("terminated");
  });
});

test("a run at a breakpoint ends at once, also with further breakpoints before the end of the cycle", async () => {
  const before = (session) => session.setBreakpoints(join(PALLETISER, "pick.pgx"), 22, 23);
  await debug(PALLETISER, { before, power: true, script: join(PALLETISER, "../../../boxes.toml") }, async (session) => {
    await session.stopped("breakpoint");
    await session.ask("terminate");
    await session.event("terminated");
    assert.equal(session.arrived("stopped").length, 0);
  });
});

test("a run that is stopped at an error ends as an operator ends it", async () => {
  const own = new Application("failing", {
    data: { "num nZero": "" },
    programs: `
program start()
begin
  nZero=1/nZero
end
program stop()
begin
  logMsg("stopped by the operator")
end
`,
  });
  for (const options of [{}, { stopOnExit: true }, { stopOnExit: true, time: "real" }]) {
    await debug(own.folder(), options, async (session) => {
      await session.stopped("exception");
      await session.ask("terminate");
      await session.eventWhere("output", ({ output }) => output.includes("stopped by the operator"));
      await session.event("terminated");
      assert.equal(session.arrived("stopped").length, 0);
    });
  }
  own.remove();
});

test("without debugging nothing stops the run", async () => {
  const own = counter();
  const before = (session) => session.setBreakpoints(own.file("start"), own.line("start", "call add"));
  await debug(own.folder(), { before, noDebug: true }, async (session) => {
    await session.event("terminated");
    assert.deepEqual(session.arrived("stopped"), []);
    const { output, category } = await session.eventWhere("output", ({ output }) => output.includes("done"));
    assert.deepEqual([output, category], ["info: USR done\n", "console"]);
  });
  own.remove();
});

test("what cannot be is refused", async () => {
  const session = await Session.start();
  assert.match(await session.refused("threads"), /launch/);
  assert.match(await session.refused("launch", { program: "/nowhere" }), /nowhere/);
  assert.match(await session.refused("unknown"), /unknown/);
  assert.equal(await session.end(), 0);
  await debug(app.folder(), { time: "real" }, async (running) => {
    const isStart = ({ reason }) => reason === "started";
    for (let task = 0; task < 4; task += 1) await running.eventWhere("thread", isStart);
    const threadId = await threadOf(running, "ticks");
    assert.equal(await running.refused("next", { threadId }), "notStopped");
    assert.equal(await running.refused("reverseContinue", { threadId }), "notStopped");
    assert.match(await running.refused("readMemory", { memoryReference: "0", count: 1 }), /does not have/);
  });
});

test("a request that has not begun is cancelled", async () => {
  const own = counter();
  await debug(own.folder(), { stopOnEntry: true }, async (session) => {
    await session.stopped("entry");
    // An endless loop in the console, and a request after it.
    const [{ id: frameId }] = await session.frames();
    const busy = session.refused("evaluate", { expression: "do\n nSum=nSum+1\n until false", frameId, context: "repl" });
    const waiting = session.refused("evaluate", { expression: "1+1", frameId, context: "watch" });
    const requestId = session.client.sequence - 1;
    const cancels = [requestId, requestId - 1].map((requestId) => session.ask("cancel", { requestId }));
    await Promise.all(cancels);
    assert.deepEqual([await busy, await waiting], ["cancelled", "cancelled"]);
  });
  own.remove();
});

test("a waiting request is cancelled while another one continues", async () => {
  const own = counter();
  await debug(own.folder(), { stopOnEntry: true }, async (session) => {
    await session.stopped("entry");
    const [{ id: frameId }] = await session.frames();
    let hasEnded = false;
    const busy = session.refused("evaluate", { expression: "do\n nSum=nSum+1\n until false", frameId, context: "repl" });
    void busy.then(() => { hasEnded = true; });
    const first = session.client.sequence - 1;
    const waiting = session.refused("evaluate", { expression: "1+1", frameId, context: "watch" });
    await session.ask("cancel", { requestId: first + 1 });
    assert.deepEqual([await waiting, hasEnded], ["cancelled", false]);
    await session.ask("cancel", { requestId: first });
    assert.equal(await busy, "cancelled");
  });
  own.remove();
});

test("statements that are executed in the console are cancelled", async () => {
  const own = counter();
  await debug(own.folder(), { stopOnEntry: true }, async (session) => {
    await session.stopped("entry");
    const [{ id: frameId }] = await session.frames();
    const loop = { expression: "do\n nSum=nSum+1\n until false", frameId, context: "repl" };
    const busy = session.refused("evaluate", loop);
    const requestId = session.client.sequence - 1;
    // The loop has begun.
    await new Promise((resolve) => setTimeout(resolve, 20));
    await session.ask("cancel", { requestId });
    // Without the request, the loop ends at the limit of lines, with another message.
    assert.equal(await busy, "cancelled");
    assert.ok(Number(await session.evaluate("nSum")) > 0);
  });
  own.remove();
});

test("a run in which no task can continue stops, and continues after the input is forced", async () => {
  const link = String.raw`BasicIO-1\%I0`;
  const own = new Application("stuck", {
    data: { "dio diIn": `link="${link}"`, "num nA": "" },
    programs: "\nprogram start()\nbegin\n  nA=1\n  wait(diIn)\n  putln(\"on\")\n  nA=2\nend\n",
  });
  try {
    await debug(own.folder(), {}, async (session) => {
      const stop = await session.stopped("pause");
      assert.match(stop.description, /no task can continue/);
      assert.match(stop.text, /waits for a condition at start\(\) line/);
      assert.match((await session.eventWhere("output", ({ category }) => category === "stderr")).output, /no task can continue/);
      await session.run("stepBack", "step");
      assert.equal(await session.evaluate("nA"), "1");
      await session.run("next", "pause");
      const io = (await session.scope("I/O")).variables;
      const { variablesReference } = io.find(({ name }) => name === "BasicIO-1");
      const set = await session.ask("setVariable", { variablesReference, name: "%I0", value: "true" });
      assert.equal(set.value, "true (input)");
      assert.match(await session.evaluate("diIn"), /^true/, "all views agree");
      const { signals } = await session.ask("val3/io");
      assert.equal(signals.find((signal) => signal.link === link).value, 1);
      await session.ask("continue", { threadId: session.thread });
      const printed = await session.eventWhere("output", ({ category }) => category === "stdout");
      assert.deepEqual([printed.output, printed.line], ["on\n", own.line("start", "putln")]);
      await session.event("terminated");
    });
  } finally {
    own.remove();
  }
});

test("where no task can continue, the text is for people at a screen", async () => {
  const own = new Application("powerless", {
    data: { "joint jA": `j3="90"`, "mdesc mFast": `vel="100"` },
    programs: "\nprogram start()\nbegin\n  movej(jA,flange,mFast)\n  waitEndMove()\nend\n",
  });
  try {
    await debug(own.folder(), {}, async (session) => {
      const { text } = await session.stopped("pause");
      assert.match(text, /^task `.*` waits for the arm \(`waitEndMove`\): no power, at start\(\) line \d+\. The arm has no power\. Switch the power on\.$/);
      const { output } = await session.eventWhere("output", ({ output }) => output.startsWith("no task can continue"));
      assert.match(output, /\n  The arm has no power\. Switch the power on\.\n$/);
      await session.ask("val3/operate", { power: true });
      await session.ask("continue", { threadId: session.thread });
      await session.event("terminated");
    });
  } finally {
    own.remove();
  }
});

test("a step that waits long says for what, and ends when the wait does", async () => {
  const own = new Application("waiting", {
    data: { "dio diGo": String.raw`link="BasicIO-1\%I0"`, "num nDone": "" },
    programs: "\nprogram start()\nbegin\n  taskCreate \"clock\",10,clock()\n  wait(diGo)\n  nDone=1\nend\n" +
      "program clock()\nbegin\n  while true\n    delay(0.1)\n  endWhile\nend\n",
  });
  try {
    await debug(own.folder(), { stopOnEntry: true, time: "real" }, async (session) => {
      await session.stopped("entry");
      await session.run("next", "step");
      await session.ask("next", { threadId: session.thread });
      const { output } = await session.eventWhere("output", ({ output }) => output.includes("the step has not ended"));
      assert.match(output, /^note: the step has not ended yet: task `.*` waits for a condition at start\(\) line \d+\n$/);
      await session.ask("val3/ioForce", { link: String.raw`BasicIO-1\%I0`, value: true });
      await session.stopped("step");
      assert.equal(await session.place(), `start:${own.line("start", "nDone=1")}`);
    });
  } finally {
    own.remove();
  }
});

test("a run that only a program at a socket can continue says so", async () => {
  const server = createServer().listen(0, "127.0.0.1");
  await once(server, "listening");
  const { port } = server.address();
  await new Promise((resolve) => { server.close(resolve); });
  const link = String.raw`Socket\host`;
  const own = new Application("listening", {
    data: { "sio siHost": `link="${link}"`, "num nByte": "", "num nRead": "" },
    programs: "\nprogram start()\nbegin\n  nRead=sioGet(siHost,nByte)\n  putln(nByte)\nend\n",
  });
  try {
    await debug(own.folder(), { line: [`${link}=server:${port}`] }, async (session) => {
      const { output } = await session.eventWhere("output", ({ output }) => output.includes("only data over"));
      assert.match(output, /^note: only data over a serial line or socket can continue the run.*\n  task `.*` waits for .*sioGet.* at start\(\) line \d+\n$/);
      const client = connect(port, "127.0.0.1");
      await once(client, "connect");
      client.write(Buffer.from([65]));
      const printed = await session.eventWhere("output", ({ category }) => category === "stdout");
      assert.equal(printed.output, "65\n");
      await session.event("terminated");
      client.destroy();
      assert.deepEqual(session.arrived("output").filter(({ output }) => output.includes("only data over")), []);
    });
  } finally {
    own.remove();
  }
});

test("a step over an instruction that fails ends with its error", async () => {
  const own = new Application("gripping", {
    data: { "tool tGrip": "", "num nDone": "" },
    programs: "\nprogram start()\nbegin\n  open(tGrip)\n  nDone=1\nend\n",
  });
  try {
    await debug(own.folder(), { stopOnEntry: true, arm: "tx2-60", power: true }, async (session) => {
      await session.stopped("entry");
      const stop = await session.run("next", "exception");
      assert.match(stop.text, /^error 123: .*tGrip/);
      assert.equal(await session.place(), `start:${own.line("start", "open")}`);
    });
  } finally {
    own.remove();
  }
});

test("a stack frame has the columns of its statement", async () => {
  const own = new Application("columns", { programs: "\nprogram start()\nbegin\n  delay(0)\n    call work()\nend\nprogram work()\nbegin\n\tdelay(1)\nend\n" });
  try {
    await debug(own.folder(), { stopOnEntry: true }, async (session) => {
      await session.stopped("entry");
      const places = async () => (await session.frames()).map(({ line, column, endLine, endColumn }) => [line, column, endLine, endColumn]);
      const at = (program, code, column) => {
        const line = own.line(program, code);
        return [line, column, line, column + code.length];
      };
      assert.deepEqual(await places(), [at("start", "delay(0)", 3)]);
      await session.run("next", "step");
      await session.run("stepIn", "step");
      assert.deepEqual(await places(), [at("work", "delay(1)", 2), at("start", "call work()", 5)]);
    });
  } finally {
    own.remove();
  }
});
