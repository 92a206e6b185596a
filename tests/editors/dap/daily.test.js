// Daily moments of a debugger: output with its line, faults, forced inputs, values to copy, a recording of a colleague.
const assert = require("node:assert/strict");
const { execFileSync } = require("node:child_process");
const { join } = require("node:path");
const { test } = require("node:test");
const { Application } = require("./application");
const { debug } = require("./session");

const PALLETISER = join(process.env.VAL3_ROOT, "examples/palletiser/usr/usrapp/palletiser");
const LINK = String.raw`BasicIO-1\%I0`;

/** Debugs an application of these programs, and removes it. */
async function debugging(options, contents, test) {
  const own = new Application("daily", contents);
  try {
    await debug(own.folder(), options, (session) => test(session, own));
  } finally {
    own.remove();
  }
}

/** Waits for the end of the run, and returns its output with the lines of programs. */
async function outputOf(session) {
  await session.event("terminated");
  const shown = session.arrived("output").filter(({ line }) => line !== undefined);
  return shown.map(({ output, category, line }) => [output, category, line]);
}

const SPEAKING = {
  programs: `
program start()
begin
  put("a")
  putln("b")
  ? 1+1
  logMsg("c")
  popUpMsg("d")
end
`,
};

test("output of programs has its line", async () => {
  await debugging({}, SPEAKING, async (session, own) => {
    const at = (text) => own.line("start", text);
    const [put, putln, shown, logged, popUp] = await outputOf(session);
    assert.deepEqual(put, ["a", "stdout", at("put(")]);
    assert.deepEqual(putln, ["b\n", "stdout", at("putln(")]);
    assert.deepEqual(shown, ["2\n", "stdout", at("? 1")]);
    assert.deepEqual([logged[0].includes("c"), logged[2]], [true, at("logMsg")]);
    assert.deepEqual([popUp[0].includes("d"), popUp[2]], [true, at("popUpMsg")]);
  });
});

test("a client that shows the user page has no output of it", async () => {
  await debugging({ screenOutput: false }, SPEAKING, async (session, own) => {
    const lines = (await outputOf(session)).map(([, , line]) => line);
    assert.deepEqual(lines, ["? 1", "logMsg", "popUpMsg"].map((text) => own.line("start", text)));
  });
});

test("a fault without filters can be inspected, and one goes back from it", async () => {
  const contents = {
    data: { "num nL[3]": "", "num nAt": "" },
    programs: "\nprogram start()\nbegin\n  nAt=2\n  nAt=9\n  nL[nAt]=1\nend\n",
  };
  await debugging({}, contents, async (session, own) => {
    const stop = await session.stopped("exception");
    assert.match(stop.text, /^error 20: /);
    assert.deepEqual([await session.place(), await session.evaluate("nAt")], [`start:${own.line("start", "nL[")}`, "9"]);
    const info = await session.ask("exceptionInfo", { threadId: session.thread });
    assert.deepEqual([info.exceptionId, info.breakMode], ["error 20", "unhandled"]);
    await session.run("stepBack", "step");
    await session.run("stepBack", "step");
    assert.deepEqual([await session.place(), await session.evaluate("nAt")], [`start:${own.line("start", "nAt=9")}`, "2"]);
  });
});

test("an error of an input names the variable", async () => {
  const contents = { data: { "dio diFree": "" }, programs: "\nprogram start()\nbegin\n  wait(diFree)\nend\n" };
  await debugging({}, contents, async (session) => {
    const stop = await session.stopped("exception");
    assert.equal(stop.text, "error 123: input or output not linked: `diFree` has no link");
  });
});

test("a linked variable forces its input, and all views agree", async () => {
  const contents = {
    data: { "dio diIn": `link="${LINK}"`, "num nCount": "" },
    programs: "\nprogram start()\nbegin\n  nCount=0\n  while diIn\n    nCount=nCount+1\n    delay(1)\n  endWhile\nend\n",
  };
  await debugging({ stopOnEntry: true }, contents, async (session) => {
    await session.stopped("entry");
    const signal = async () => (await session.ask("val3/io")).signals.find(({ link }) => link === LINK).value;
    const views = async () => [(await session.evaluate("diIn")).split(" ")[0], await signal()];
    const [{ id: frameId }] = await session.frames();
    await session.ask("setExpression", { expression: "diIn", value: "true", frameId });
    assert.deepEqual(await views(), ["true", 1]);
    await session.evaluate("diIn=false", "repl");
    assert.deepEqual(await views(), ["false", 0]);
    await session.ask("val3/ioForce", { link: LINK, value: true });
    assert.deepEqual(await views(), ["true", 1]);
    const { variables } = await session.scope("Globals");
    assert.match(variables.find(({ name }) => name === "diIn").value, /^true/);
    await session.run("next", "step");
    await session.run("next", "step");
    await session.run("next", "step");
    assert.equal(await session.evaluate("nCount"), "1", "the program reads the forced input");
  });
});

test("values to copy have all digits and no notes", async () => {
  const contents = {
    data: { "dio diIn": `link="${LINK}"`, "num nThird": "", "num nOne[1]": "" },
    programs: `
program start()
begin
  nThird=1/3
  call work(nThird)
end
program work(num& x_nOther)
begin
  delay(0)
end
`,
  };
  await debugging({ stopOnEntry: true }, contents, async (session, own) => {
    await session.stopped("entry");
    await session.setBreakpoints(own.file("work"), own.line("work", "delay"));
    await session.run("continue", "breakpoint");
    const shown = (name) => Promise.all(["clipboard", "watch", "hover"].map((context) => session.evaluate(name, context)));
    const [copied, watched, hovered] = await shown("nThird");
    assert.deepEqual([copied, watched], ["0.3333333333333333", "0.3333333333333333"]);
    assert.match(hovered, /^0\.33333333333333 · since /);
    assert.match(await session.evaluate("x_nOther"), /refers to nThird/);
    assert.equal(await session.evaluate("x_nOther", "clipboard"), "0.3333333333333333");
    assert.equal(await session.evaluate("diIn", "clipboard"), "false");
    assert.equal(await session.evaluate("nOne[0]"), "0", "the expression names the variable itself");
    const { variablesReference, variables } = await session.scope("Globals");
    const { value } = variables.find(({ name }) => name === "nThird");
    await session.ask("setVariable", { variablesReference, name: "nThird", value });
    assert.equal(await session.evaluate("nThird==1/3"), "true", "a confirmed value is unchanged");
    const beyond = { variablesReference: (await session.scope("Globals")).variablesReference, name: "nThird", value: "1e400" };
    assert.match(await session.refused("setVariable", beyond), /range|large|number/);
  });
});

test("a recording of a colleague opens at its end", async () => {
  const own = new Application("daily", {
    data: { "num nCount": "" },
    programs: "\nprogram start()\nbegin\n  while true\n    nCount=nCount+1\n    delay(1)\n  endWhile\nend\n",
  });
  try {
    const replay = join(own.cell, "run.jsonl");
    execFileSync(process.env.VAL3_SERVER, ["run", own.folder(), "--until", "2.5", "--until-ok", "--events", replay], { stdio: "ignore" });
    await debug(own.folder(), { replay, startAtEnd: true }, async (session) => {
      const stop = await session.event("stopped");
      session.thread = stop.threadId;
      assert.deepEqual([stop.description, await session.evaluate("nCount")], ["Paused at the end of the recording", "3"]);
      await session.watchData("nCount");
      assert.match((await session.run("reverseContinue", "data breakpoint")).text, /^2 -> 3 /);
    });
  } finally {
    own.remove();
  }
});

test("skipped programs are stepped over", async () => {
  const contents = {
    data: { "num nA": "" },
    programs: "\nprogram start()\nbegin\n  call work()\n  nA=1\nend\nprogram work()\nbegin\n  nA=2\nend\n",
  };
  await debugging({ stopOnEntry: true, skip: ["daily:w*"] }, contents, async (session, own) => {
    await session.stopped("entry");
    await session.run("stepIn", "step");
    assert.equal(await session.place(), `start:${own.line("start", "nA=1")}`);
  });
});

test("a statement without a stack frame notes the breakpoints that it passes", async () => {
  const contents = {
    data: { "num nA": "" },
    programs: "\nprogram start()\nbegin\n  nA=1\nend\nprogram work()\nbegin\n  nA=2\nend\n",
  };
  await debugging({ stopOnEntry: true }, contents, async (session, own) => {
    await session.stopped("entry");
    await session.setBreakpoints(own.file("work"), own.line("work", "nA=2"));
    await session.ask("evaluate", { expression: "call work()", context: "repl" });
    await session.eventWhere("output", ({ output }) => output.startsWith("note: the code has passed breakpoints 1 time"));
    assert.equal(await session.evaluate("nA"), "2");
  });
});

test("a key ends a wait in which no task could continue", async () => {
  const contents = { data: { "num nKey": "" }, programs: "\nprogram start()\nbegin\n  nKey=get()\n  putln(\"key\")\nend\n" };
  await debugging({}, contents, async (session) => {
    await session.stopped("pause");
    await session.ask("val3/key", { key: "F1" });
    await session.ask("continue", { threadId: session.thread });
    await session.eventWhere("output", ({ output }) => output === "key\n");
    await session.event("terminated");
  });
});

test("a breakpoint tells how often it was hit", async () => {
  await debug(PALLETISER, { stopOnEntry: true, script: join(process.env.VAL3_ROOT, "examples/palletiser/boxes.toml") }, async (session) => {
    await session.stopped("entry");
    const [before] = await session.setBreakpoints(join(PALLETISER, "sensors.pgx"), 11);
    assert.equal(before.message, undefined);
    await session.run("continue", "breakpoint");
    const { breakpoint } = await session.eventWhere("breakpoint", ({ breakpoint }) => breakpoint.id === before.id);
    assert.equal(breakpoint.message, "hit once");
    await session.run("continue", "breakpoint");
    const again = await session.eventWhere("breakpoint", ({ breakpoint }) => breakpoint.id === before.id);
    assert.equal(again.breakpoint.message, "hit 2 times");
  });
});
