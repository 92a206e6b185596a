// Calls of the debug console that stop at breakpoints, and earlier values on hover.
const assert = require("node:assert/strict");
const { test } = require("node:test");
const { Application } = require("./application");
const { debug } = require("./session");

const CALLING = {
  data: { "num nA": "", "num nB": "" },
  programs: `
program start()
begin
  nB=1
  nB=2
  delay(1)
end

program sub(num x_nCount)
num l_nI
begin
  for l_nI=1 to x_nCount
    nA=nA+l_nI
  endFor
  delay(0.1)
end

program wrong()
begin
  nA=nA/(nB-1)
end
`,
};

/** Debugs the application from before its second line. */
async function debugging(test) {
  const own = new Application("console", CALLING);
  const before = (session) => session.setBreakpoints(own.file("start"), own.line("start", "nB=2"));
  try {
    await debug(own.folder(), { before }, async (session) => {
      await session.stopped("breakpoint");
      await test(session, own);
    });
  } finally {
    own.remove();
  }
}

async function execute(session, expression) {
  const [{ id }] = await session.frames();
  return (await session.ask("evaluate", { expression, frameId: id, context: "repl" })).result;
}

async function value(session, expression, context = "watch") {
  const [{ id }] = await session.frames();
  return (await session.ask("evaluate", { expression, frameId: id, context })).result;
}

const stack = async (session) => (await session.frames()).map(({ name }) => name);
const AFTER = "Paused after the call from the debug console";

test("a call stops at a breakpoint, is stepped, and returns to where it was made", async () => {
  await debugging(async (session, own) => {
    const here = (await session.frames())[0].line;
    await session.setBreakpoints(own.file("sub"), own.line("sub", "nA=nA"));
    assert.match(await execute(session, "call sub(2)"), /^stopped in the called program/);
    await session.stopped("breakpoint");
    assert.deepEqual(await stack(session), ["console:sub()", "called from the debug console", "console:start()"]);
    assert.equal((await session.frames())[1].presentationHint, "label");
    assert.equal(await value(session, "l_nI"), "1");
    await session.ask("next", { threadId: session.thread });
    await session.stopped("step");
    assert.equal(await value(session, "nA"), "1");
    await session.ask("stepBack", { threadId: session.thread });
    await session.stopped("step");
    assert.equal(await value(session, "nA"), "0");
    await session.setBreakpoints(own.file("sub"));
    await session.ask("continue", { threadId: session.thread });
    assert.equal((await session.stopped("pause")).description, AFTER);
    assert.deepEqual([await stack(session), (await session.frames())[0].line], [["console:start()"], here]);
    assert.deepEqual([await value(session, "nA"), await value(session, "nB")], ["3", "1"]);
    await session.ask("next", { threadId: session.thread });
    await session.stopped("step");
    assert.equal(await value(session, "nB"), "2");
  });
});

test("an error in a stopped call ends the call, and the task continues", async () => {
  await debugging(async (session, own) => {
    await session.setBreakpoints(own.file("wrong"), own.line("wrong", "nA=nA"));
    await execute(session, "call wrong()");
    await session.stopped("breakpoint");
    await session.ask("continue", { threadId: session.thread });
    await session.stopped("exception");
    await session.ask("continue", { threadId: session.thread });
    const { description, text } = await session.stopped("pause");
    assert.deepEqual([description, /^error 10 has ended the call/.test(text)], [AFTER, true]);
    await session.ask("next", { threadId: session.thread });
    await session.stopped("step");
    assert.equal(await value(session, "nB"), "2");
  });
});

test("a stopped call is ended by a request", async () => {
  await debugging(async (session, own) => {
    await session.setBreakpoints(own.file("sub"), own.line("sub", "delay"));
    await execute(session, "call sub(1)");
    await session.stopped("breakpoint");
    await session.ask("val3/endCall", { threadId: session.thread });
    assert.equal((await session.stopped("pause")).description, AFTER);
    assert.deepEqual(await stack(session), ["console:start()"]);
  });
});

test("hover shows earlier values, other contexts the value alone", async () => {
  await debugging(async (session, own) => {
    await session.ask("next", { threadId: session.thread });
    await session.stopped("step");
    const line = (text) => own.line("start", text);
    const expected = `2 · since 0.000 s, start() line ${line("nB=2")} · before: 1 (0.000 s, start() line ${line("nB=1")}), 0 (initially)`;
    assert.equal(await value(session, "nB", "hover"), expected);
    for (const context of ["watch", "clipboard", "variables"]) {
      assert.equal(await value(session, "nB", context), "2");
    }
  });
});
