// Breakpoints on data: variables, elements, fields, inputs and outputs.
const assert = require("node:assert/strict");
const { join } = require("node:path");
const { after, before, test } = require("node:test");
const { counter } = require("./counter");
const { debug } = require("./session");
const { shapes } = require("./shapes");

const PALLETISER = join(process.env.VAL3_ROOT, "examples/palletiser/usr/usrapp/palletiser");

let app;
before(() => { app = counter(); });
after(() => app.remove());

/** Debugs the counter from its first line. */
async function counting(test) {
  await debug(app.folder(), { stopOnEntry: true }, async (session) => {
    await session.stopped("entry");
    await test(session);
  });
}

test("a variable that changes stops the run after the line", async () => {
  await counting(async (session) => {
    const [info, placed] = await session.watchData("nSum");
    assert.deepEqual(info.accessTypes, ["read", "write", "readWrite"]);
    assert.equal(placed.verified, true);
    const stop = await session.run("continue", "data breakpoint");
    assert.deepEqual(stop.hitBreakpointIds, [placed.id]);
    const written = `counter:add(), line ${app.line("add", "x_nTotal=")}`;
    assert.equal(stop.text, `0 -> 1 (${written})`);
    assert.equal((await session.run("continue", "data breakpoint")).text, `1 -> 3 (${written})`);
  });
});

test("an element, a local and a variable of a library", async () => {
  await counting(async (session) => {
    await session.watchData("nMany[2]");
    assert.match((await session.run("continue", "data breakpoint")).text, /^0 -> 3 /);
    await session.watchData("tools:nCalls", { hitCondition: ">=3" });
    assert.match((await session.run("continue", "data breakpoint")).text, /^3 -> 4 \(tools:square/);
    await session.ask("setDataBreakpoints", { breakpoints: [] });
    await session.setBreakpoints(app.file("add"), app.line("add", "l_nBefore="));
    await session.run("continue", "breakpoint");
    await session.setBreakpoints(app.file("add"));
    const [info] = await session.watchData("l_nBefore");
    assert.match(info.description, /l_nBefore/);
    assert.match((await session.run("continue", "data breakpoint")).text, /^0 -> 10 \(counter:add/);
  });
});

test("a line that reads stops the run, whatever it writes", async () => {
  await counting(async (session) => {
    await session.watchData("nMany[3]", { accessType: "read" });
    await session.ask("setFunctionBreakpoints", { breakpoints: [] });
    await session.ask("continue", { threadId: session.thread });
    await session.event("terminated");
    assert.deepEqual(session.arrived("stopped"), [], "the program writes it alone");
  });
  await counting(async (session) => {
    await session.watchData("nSum", { accessType: "read" });
    const stop = await session.run("continue", "data breakpoint");
    assert.equal(stop.text, `read: 0 (counter:add(), line ${app.line("add", "l_nBefore=")})`);
  });
  await counting(async (session) => {
    await session.watchData("nSum", { accessType: "readWrite" });
    const texts = [];
    for (let stops = 0; stops < 3; stops += 1) texts.push((await session.run("continue", "data breakpoint")).text);
    assert.deepEqual(texts.map((text) => text.split(" (")[0]), ["read: 0", "0 -> 1", "read: 1"]);
  });
});

test("the number of hits counts, and a condition chooses the changes", async () => {
  await counting(async (session) => {
    await session.watchData("nSum", { hitCondition: "%4" });
    assert.match((await session.run("continue", "data breakpoint")).text, /^6 -> 10 /);
    await session.watchData("nSum", { condition: "nSum>20" });
    assert.match((await session.run("continue", "data breakpoint")).text, /^15 -> 21 /);
    const [, refused] = await session.watchData("nSum", { condition: "nSum" });
    assert.equal(refused.verified, false);
    assert.match(refused.message, /a condition is a bool/);
  });
});

test("an index that is a variable has its value of now", async () => {
  await counting(async (session) => {
    await session.evaluate("nIndex=3", "repl");
    const [info] = await session.watchData("nMany[nIndex]");
    assert.match(info.dataId, /nMany\[3\]$/);
    const stop = await session.run("continue", "data breakpoint");
    assert.match(stop.text, /^0 -> 6 /);
    assert.equal(await session.evaluate("nIndex"), "3");
  });
});

test("data from the list of variables can be watched, and what is computed cannot", async () => {
  await counting(async (session) => {
    const { variablesReference } = await session.scope("Globals");
    const info = await session.ask("dataBreakpointInfo", { variablesReference, name: "sText" });
    await session.ask("setDataBreakpoints", { breakpoints: [{ dataId: info.dataId, accessType: "write" }] });
    assert.match((await session.run("continue", "data breakpoint")).text, /^"none" -> "done"/);
    const none = await session.ask("dataBreakpointInfo", { name: "nothing" });
    assert.equal(none.dataId, null);
    assert.match(none.description, /nothing/);
  });
});

test("the run goes back to the last change of watched data", async () => {
  await counting(async (session) => {
    await session.setBreakpoints(app.file("start"), app.line("start", "sText="));
    await session.run("continue", "breakpoint");
    await session.watchData("nMany[4]");
    assert.match((await session.run("reverseContinue", "data breakpoint")).text, /^0 -> 10 /);
    assert.equal(await session.evaluate("nIndex"), "4");
    assert.equal(await session.evaluate("nMany[5]"), "0");
    assert.match((await session.run("reverseContinue", "entry")).description, /beginning/);
  });
});

test("inputs and outputs stop the run when they change", async () => {
  const script = join(process.env.VAL3_ROOT, "examples/palletiser/boxes.toml");
  await debug(PALLETISER, { stopOnEntry: true, script }, async (session) => {
    await session.stopped("entry");
    const names = ["BasicIO-1\\%Q5", "BasicIO-1\\%I0"];
    const infos = await Promise.all(names.map((name) => session.ask("dataBreakpointInfo", { name })));
    assert.deepEqual(infos[0].accessTypes, ["read", "write", "readWrite"]);
    const { breakpoints } = await session.ask("setDataBreakpoints", { breakpoints: infos.map(({ dataId }) => ({ dataId, accessType: "write" })) });
    const lamp = await session.run("continue", "data breakpoint");
    assert.deepEqual(lamp.hitBreakpointIds, [breakpoints[0].id]);
    assert.match(lamp.text, /^false -> true \(palletiser:tower\(\), line \d+\)/);
    await session.ask("setDataBreakpoints", { breakpoints: [{ dataId: infos[1].dataId }] });
    // The script switches the input.
    const part = await session.run("continue", "data breakpoint");
    assert.equal(part.text, "false -> true");
    assert.equal((await session.ask("val3/pose")).t, 1);
    await session.ask("setDataBreakpoints", { breakpoints: [{ dataId: infos[1].dataId, accessType: "read" }] });
    const read = await session.run("continue", "data breakpoint");
    assert.match(read.text, /^read: true \(palletiser:sensors\(\), line 11\)/);
  });
});

test("an output is watched through the variable that is linked to it", async () => {
  await debug(PALLETISER, { stopOnEntry: true }, async (session) => {
    await session.stopped("entry");
    const [, output] = await session.watchData("io:doTower[\"amber\"]");
    assert.equal(output.verified, true);
    assert.match((await session.run("continue", "data breakpoint")).text, /^false.* -> true/);
  });
});

test("a field is watched alone", async () => {
  const own = shapes();
  await debug(own.folder(), { stopOnEntry: true }, async (session) => {
    await session.stopped("entry");
    await session.watchData("pHole.trsf.y");
    assert.match((await session.run("continue", "data breakpoint")).text, /^2 -> 7 /);
    assert.equal(await session.evaluate("pHole.trsf.x"), "5", "the line before has changed x");
  });
  own.remove();
});
