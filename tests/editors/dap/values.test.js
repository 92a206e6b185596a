// Frames, scopes and values, and changes of values.
const assert = require("node:assert/strict");
const { join } = require("node:path");
const { after, before, test } = require("node:test");
const { Application } = require("./application");
const { debug } = require("./session");
const { shapes } = require("./shapes");

const PALLETISER = join(process.env.VAL3_ROOT, "examples/palletiser/usr/usrapp/palletiser");

let app;
before(() => { app = shapes(); });
after(() => app.remove());

/** Debugs the application before the second line of its program `show`. */
async function showing(test, options = {}) {
  const before = (session) => session.setBreakpoints(app.file("show"), app.line("show", "x_nCell="));
  await debug(app.folder(), { before, ...options }, async (session) => {
    await session.stopped("breakpoint");
    await test(session);
  });
}

const texts = (variables) => variables.map(({ name, value }) => `${name}=${value}`);

test("the frames of a task, page by page", async () => {
  await showing(async (session) => {
    const all = await session.frames();
    assert.deepEqual(all.map(({ name, line }) => [name, line]), [
      ["shapes:show()", app.line("show", "x_nCell=")], ["shapes:start()", app.line("start", "call show")],
    ]);
    const threadId = session.thread;
    const page = await session.ask("stackTrace", { threadId, startFrame: 1, levels: 1, format: { line: true } });
    assert.equal(page.totalFrames, 2);
    const [{ name, source }] = page.stackFrames;
    assert.deepEqual([page.stackFrames.length, name], [1, `shapes:start(), line ${app.line("start", "call show")}`]);
    assert.deepEqual([source.name, source.path], ["start.pgx", app.file("start")]);
  });
});

test("scopes of a frame, with what parameters by reference refer to", async () => {
  await showing(async (session) => {
    assert.deepEqual(texts((await session.scope("Parameters")).variables), ["x_nCopy=4", "x_nCell=12 (refers to nGrid[1,2])"]);
    const { variables: locals, presentationHint } = await session.scope("Locals");
    assert.equal(presentationHint, "locals");
    assert.deepEqual(locals.map(({ name, type }) => `${name} ${type}`), ["l_trAt trsf", "l_nMany num[4]"]);
    assert.deepEqual(texts(await session.inside(locals[0])).slice(3), ["rx=0", "ry=0", "rz=90"]);
    const globals = (await session.scope("Globals", 1)).variables.map(({ name }) => name);
    assert.deepEqual(globals.sort(), ["bFlag", "fHole", "fPart", "jHome", "nGrid", "nLong", "pHole", "sName"]);
    assert.deepEqual((await session.scope("Locals", 1)).variables, []);
  });
});

test("a long array is paged", async () => {
  await showing(async (session) => {
    const array = await session.variable("Globals", "nLong");
    assert.deepEqual([array.indexedVariables, array.type], [100000, "num[100000]"]);
    const page = await session.inside(array, { filter: "indexed", start: 99998, count: 5 });
    assert.deepEqual(texts(page), ["[99998]=0", "[99999]=0"]);
    assert.equal(page[1].evaluateName, "nLong[99999]");
    assert.deepEqual(await session.inside(array, { filter: "named" }), []);
    assert.deepEqual(texts(await session.inside(await session.variable("Globals", "nGrid"), { start: 4 })), ["[1,1]=0", "[1,2]=12"]);
  });
});

test("a point has its frames up to the world, and its pose there", async () => {
  await showing(async (session) => {
    const point = await session.variable("Globals", "pHole");
    const inside = await session.inside(point);
    const trsf = await session.inside(inside.find(({ name }) => name === "trsf"));
    assert.deepEqual(texts(trsf).slice(0, 3), ["x=5", "y=7", "z=3"]);
    const names = inside.map(({ name }) => name);
    assert.deepEqual(names, ["trsf", "config", "father", "world"]);
    const [, , father, world] = inside;
    assert.match(father.value, /fHole/);
    const chain = await session.inside(father);
    assert.match(chain.find(({ name }) => name === "father").value, /fPart/);
    // 90 degrees about z, then 100 mm along x.
    assert.deepEqual(texts(await session.inside(world)).slice(0, 3), ["x=93", "y=5", "z=3"]);
  });
});

test("values are formatted as the client asks", async () => {
  await showing(async (session) => {
    const hex = { format: { hex: true } };
    assert.equal(await session.evaluate("254+1", "watch", hex), "0xFF");
    const { variablesReference } = await session.scope("Parameters");
    assert.equal((await session.inside({ variablesReference }, hex))[0].value, "0x4");
    const set = { variablesReference, name: "x_nCopy", value: "18", ...hex };
    assert.equal((await session.ask("setVariable", set)).value, "0x12");
  });
});

test("variables, elements, fields and references are set", async () => {
  await showing(async (session) => {
    const set = async (scope, name, value) => {
      const { variablesReference } = await session.scope(scope);
      return (await session.ask("setVariable", { variablesReference, name, value })).value;
    };
    assert.equal(await set("Parameters", "x_nCell", "x_nCopy*2"), "8 (refers to nGrid[1,2])");
    await session.event("invalidated");
    assert.equal(await session.evaluate("nGrid[1,2]"), "8");
    assert.equal(await set("Globals", "sName", "\"new\""), "\"new\"");
    assert.equal(await set("Globals", "bFlag", "true"), "true");
    const { variablesReference } = await session.variable("Globals", "jHome");
    await session.ask("setVariable", { variablesReference, name: "j3", value: "45" });
    assert.equal(await session.evaluate("jHome.j3"), "45");
    const { scopes } = await session.ask("scopes", { frameId: (await session.frames())[0].id });
    const globals = scopes.find(({ name }) => name === "Globals").variablesReference;
    assert.match(await session.refused("setVariable", { variablesReference: globals, name: "nLong[100000]", value: "1" }), /./);
    assert.match(await session.refused("setVariable", { variablesReference: globals, name: "bFlag", value: "5" }), /bool/);
    assert.equal(await session.evaluate("bFlag"), "true");
    const world = (await session.inside(await session.variable("Globals", "pHole")))[3];
    const computed = { variablesReference: world.variablesReference, name: "x", value: "1" };
    assert.match(await session.refused("setVariable", computed), /computed/);
  });
});

test("expressions are set", async () => {
  await showing(async (session) => {
    const [{ id: frameId }] = await session.frames();
    const set = async (expression, value) => (await session.ask("setExpression", { expression, value, frameId })).value;
    assert.equal(await set("nLong[x_nCopy+5]", "7"), "7 (refers to nLong[9])");
    assert.equal(await session.evaluate("nLong[9]"), "7");
    assert.match(await set("l_trAt", "{1,2,3,0,0,0}"), /1.*2.*3/);
    assert.equal(await session.evaluate("l_trAt.y"), "2");
    assert.match(await session.refused("setExpression", { expression: "1+1", value: "3", frameId }), /./);
  });
});

test("hovers and watches have no side effects, the console has", async () => {
  await showing(async (session) => {
    const [{ id: frameId }] = await session.frames();
    for (const context of ["hover", "watch", "variables"]) {
      assert.equal(await session.evaluate("x_nCopy+1", context), "5");
      for (const expression of ["nLong[0]=5", "call show(1,nLong[0])", "taskKill(\"main\")", "logMsg(\"x\")"]) {
        const reason = await session.refused("evaluate", { expression, frameId, context });
        assert.ok(reason.length > 10, reason);
      }
    }
    assert.equal(await session.evaluate("nLong[0]"), "1");
    assert.deepEqual(session.arrived("invalidated"), []);
    assert.equal(await session.evaluate("nLong[0]=x_nCopy*10", "repl"), "");
    await session.event("invalidated");
    await session.setBreakpoints(app.file("show"));
    await session.evaluate("call show(1,nLong[1])", "repl");
    assert.deepEqual([await session.evaluate("nLong[0]"), await session.evaluate("nLong[1]")], ["40", "255"]);
    assert.equal(await session.evaluate("x_nCopy", "watch", { frameId: (await session.frames())[0].id }), "4");
    const [, outer] = await session.frames();
    const reason = await session.refused("evaluate", { expression: "x_nCopy", frameId: outer.id, context: "watch" });
    assert.match(reason, /x_nCopy/);
    const structured = await session.ask("evaluate", { expression: "pHole", frameId, context: "watch" });
    assert.equal((await session.inside(structured))[0].name, "trsf");
  });
});

test("the console completes names of the frame, members and instructions", async () => {
  await showing(async (session) => {
    const [{ id: frameId }] = await session.frames();
    const complete = async (text, column = text.length + 1) =>
      (await session.ask("completions", { text, column, frameId })).targets;
    const locals = (await complete("x_n")).map(({ label }) => label);
    assert.deepEqual(locals.filter((label) => label.startsWith("x_n")), ["x_nCell", "x_nCopy"]);
    assert.ok((await complete("pHole.trsf.")).some(({ label }) => label === "rz"));
    const [item] = (await complete("nGrid[0,1]+x_nCo")).filter(({ label }) => label === "x_nCopy");
    assert.deepEqual([item.start, item.length], [11, 5]);
    assert.ok((await complete("waitEnd")).some(({ label }) => label.startsWith("waitEndMove")));
    assert.deepEqual((await complete("1+1\nsNa", 4)).length, 0, "the line of the cursor counts");
    assert.ok((await session.ask("completions", { text: "1+1\nsNa", column: 4, line: 2, frameId })).targets.some(({ label }) => label === "sName"));
  });
});

test("scopes of the cell and of libraries", async () => {
  const before = (session) => session.ask("setFunctionBreakpoints", { breakpoints: [{ name: "home" }] });
  await debug(PALLETISER, { before }, async (session) => {
    await session.stopped("breakpoint");
    const names = async (scope) => (await session.scope(scope)).variables.map(({ name }) => name);
    assert.deepEqual((await names("Library io")).slice(0, 3), ["aiVacuum", "aiWeight", "diClamp"]);
    const robot = await names("Robot");
    for (const property of ["joints", "pose", "configuration", "tool", "speed", "power", "workingMode"]) {
      assert.ok(robot.includes(property), `${property} among ${robot}`);
    }
    const io = (await session.scope("I/O")).variables;
    const board = await session.inside(io.find(({ name }) => name === "BasicIO-1"));
    assert.match(board.find(({ name }) => name === "%Q5").value, /^(true|false) \(output\)$/);
    assert.ok(board.every(({ presentationHint }) => presentationHint === undefined), "each signal can be set");
    const properties = (await session.scope("Robot")).variables;
    assert.ok(properties.every(({ presentationHint }) => presentationHint.attributes.includes("readOnly")));
    assert.deepEqual(await names("Motion queue"), []);
    const slots = await session.variable("Globals", "tSlots");
    const [slot] = await session.inside(slots, { start: 5, count: 1 });
    assert.equal(slot.evaluateName, "tSlots[1,2]");
    assert.deepEqual((await session.inside(slot)).map(({ name }) => name).sort(), ["bFull", "nWeight", "pPlace", "sContent"]);
    const done = await session.inside(await session.variable("Globals", "nDone"));
    assert.deepEqual(texts(done), ["[\"bag\"]=0", "[\"box\"]=0"]);
  });
});

test("many libraries are one scope", async () => {
  const programs = "\nprogram touch()\nbegin\n  nOwn=nOwn+1\nend\n";
  const aliases = ["conveyor", "gripper", "log", "parts", "vision"];
  const libraries = Object.fromEntries(aliases.map((alias) => [alias, { data: { "num nOwn": "", "string sOwn": "" }, programs }]));
  const own = new Application("many", { libraries, programs: "\nprogram start()\nbegin\n  call vision:touch()\n  delay(1)\nend\n" });
  try {
    const before = (session) => session.setBreakpoints(own.file("start"), own.line("start", "delay"));
    await debug(own.folder(), { before }, async (session) => {
      await session.stopped("breakpoint");
      const [{ id: frameId }] = await session.frames();
      const { scopes } = await session.ask("scopes", { frameId });
      assert.deepEqual(scopes.map(({ name }) => name), ["Parameters", "Locals", "Globals", "Libraries", "I/O", "Robot", "Motion queue"]);
      const { variables } = await session.scope("Libraries");
      assert.deepEqual(texts(variables), aliases.map((alias) => `${alias}=2 variables`));
      const vision = variables.at(-1);
      assert.deepEqual(texts(await session.inside(vision)).slice(0, 1), ["nOwn=1"]);
      const { variablesReference } = vision;
      await session.ask("setVariable", { variablesReference, name: "nOwn", value: "7" });
      const info = await session.ask("dataBreakpointInfo", { variablesReference, name: "nOwn" });
      assert.match(info.dataId, /vision:nOwn/);
      assert.equal(await session.evaluate("vision:nOwn"), "7");
    });
  } finally {
    own.remove();
  }
});

test("a filter restricts the global variables by their names", async () => {
  const programs = "\nprogram touch()\nbegin\n  nOwn=nOwn+1\nend\n";
  const aliases = ["conveyor", "gripper", "log", "parts", "vision"];
  const libraries = Object.fromEntries(aliases.map((alias) => [alias, { data: { "num nOwn": "", [`num n${alias}`]: "" }, programs }]));
  const own = new Application("filtered", {
    libraries, data: { "num nPush": "", "num nPop": "", "string sName": "" }, programs: "\nprogram start()\nbegin\n  delay(1)\nend\n",
  });
  try {
    await debug(own.folder(), { stopOnEntry: true, variableFilter: "push, vision:" }, async (session) => {
      await session.stopped("entry");
      const shown = async () => {
        const [{ id: frameId }] = await session.frames();
        const { scopes } = await session.ask("scopes", { frameId });
        const ofData = scopes.filter(({ name }) => /^(Globals|Librar)/.test(name));
        const variables = await Promise.all(ofData.map((scope) => session.inside(scope)));
        return Object.fromEntries(ofData.map(({ name }, index) => [name, variables[index].map((variable) => variable.name)]));
      };
      await session.eventWhere("output", ({ output }) => output === "note: only global variables that match `push, vision:` are shown\n");
      assert.deepEqual(await shown(), { Globals: ["nPush"], "Library vision": ["nOwn", "nvision"] });
      const { filter } = await session.ask("val3/variableFilter", { filter: "nP*" });
      assert.deepEqual((await session.event("invalidated")).areas, ["variables"]);
      assert.deepEqual([filter, await shown()], ["nP*", { Globals: ["nPush", "nPop"], "Library parts": ["nparts"] }]);
      assert.match(await session.refused("val3/variableFilter", { filter: "n[" }), /write a filter such as/);
      await session.ask("val3/variableFilter", { filter: "" });
      assert.deepEqual(await shown(), { Globals: ["nPush", "nPop", "sName"], Libraries: aliases });
    });
  } finally {
    own.remove();
  }
});

test("an array is a table of values and numbers", async () => {
  await showing(async (session) => {
    const { variablesReference } = await session.scope("Globals");
    const table = await session.ask("val3/table", { name: "nGrid", variablesReference });
    assert.deepEqual([table.name, table.type, table.count], ["shapes:nGrid", "num[2,3]", 6]);
    assert.deepEqual(table.rows.at(-1), { index: "[1,2]", value: "12", numbers: [12] });
    await session.run("next", "step");
    const later = await session.ask("val3/table", { dataId: table.name, start: 5, count: 10 });
    assert.deepEqual(later.rows.map(({ numbers }) => numbers), [[255]]);
    const long = await session.ask("val3/table", { name: "nLong", start: 99_999 });
    assert.deepEqual([long.count, long.rows.map(({ index }) => index)], [100_000, ["[99999]"]]);
    assert.match(await session.refused("val3/table", { name: "pHole.trsf" }), /no array or collection/);
  });
});

test("scopes with few variables are read at each stop", async () => {
  await showing(async (session) => {
    const { expensive } = await session.scope("Globals");
    assert.equal(expensive, false);
  });
});

test("the numbers of a stop that is over are refused", async () => {
  await showing(async (session) => {
    const [{ id: frameId }] = await session.frames();
    const { variablesReference } = await session.scope("Globals");
    await session.run("next", "step");
    assert.match(await session.refused("variables", { variablesReference }), /over/);
    assert.match(await session.refused("evaluate", { expression: "1", frameId }), /over/);
    assert.match(await session.refused("scopes", { frameId: 99 }), /over/);
  });
});
