// Stops of a single task, while the other tasks, the clock and the arm continue.
const assert = require("node:assert/strict");
const { after, before, test } = require("node:test");
const { Application } = require("./application");
const { debug } = require("./session");

let app;
before(() => {
  app = new Application("pair", {
    data: { "num nFirst": "", "num nSecond": "", "num nZero": "" },
    programs: `
program start()
begin
  taskCreate "first",10,first()
  taskCreate "second",20,second()
end
program first()
begin
  while true
    nFirst=nFirst+1
    nZero=0
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
`,
  });
});
after(() => app.remove());

const OPTIONS = { stopScope: "task", time: "real" };

/** Returns the value of a number that changes while the run continues, once it is greater than `before`. */
async function grown(session, name, before) {
  for (;;) {
    const present = await value(session, name);
    if (present > before) return present;
  }
}

const value = async (session, name) => Number((await session.ask("evaluate", { expression: name, context: "watch" })).result);

test("a breakpoint stops its task alone", async () => {
  const line = app.line("first", "nFirst=");
  const before = (session) => session.setBreakpoints(app.file("first"), line);
  await debug(app.folder(), { ...OPTIONS, before }, async (session) => {
    const stop = await session.stopped("breakpoint");
    assert.equal(stop.allThreadsStopped, false);
    assert.equal(await session.place(), `first:${line}`);
    const first = await value(session, "nFirst");
    await grown(session, "nSecond", 1 + await value(session, "nSecond"));
    assert.equal(await value(session, "nFirst"), first, "the task is held");
    // A step of only this task, with its frames.
    const next = await session.run("next", "step");
    assert.equal(next.allThreadsStopped, false);
    assert.equal(await session.place(), `first:${app.line("first", "nZero=")}`);
    assert.equal(await session.evaluate("nFirst"), `${first + 1}`);
    const answer = await session.ask("continue", { threadId: session.thread });
    assert.equal(answer.allThreadsContinued, false);
    await session.stopped("breakpoint");
    assert.equal(await value(session, "nFirst"), first + 1);
  });
});

test("one task is paused, and its frames are gone when it continues", async () => {
  await debug(app.folder(), OPTIONS, async (session) => {
    await grown(session, "nSecond", 0);
    const { threads } = await session.ask("threads");
    session.thread = threads.find(({ name }) => name.startsWith("second")).id;
    await session.run("pause", "pause");
    const [{ id: frameId }] = await session.frames();
    const second = await value(session, "nSecond");
    await grown(session, "nFirst", 1 + await value(session, "nFirst"));
    assert.equal(await value(session, "nSecond"), second);
    assert.match(await session.refused("stepBack", { threadId: session.thread }), /notStopped/);
    await session.ask("continue", { threadId: session.thread });
    assert.match(await session.refused("scopes", { frameId }), /over/);
    await grown(session, "nSecond", second);
    assert.equal(await session.refused("next", { threadId: session.thread }), "notStopped");
    // A thread that does not exist means all threads.
    session.thread = 0;
    const stop = await session.run("pause", "pause");
    assert.equal(stop.allThreadsStopped, true);
    const all = await value(session, "nFirst");
    assert.equal(await value(session, "nFirst"), all);
    await session.ask("continue", { threadId: stop.threadId });
    await grown(session, "nFirst", all);
  });
});

test("two tasks are stopped, and each continues for itself", async () => {
  const before = async (session) => {
    await session.setBreakpoints(app.file("first"), app.line("first", "nFirst="));
    await session.setBreakpoints(app.file("second"), app.line("second", "nSecond="));
  };
  await debug(app.folder(), { ...OPTIONS, before }, async (session) => {
    const one = (await session.stopped("breakpoint")).threadId;
    const other = (await session.stopped("breakpoint")).threadId;
    assert.notEqual(one, other);
    const places = [await session.place(one), await session.place(other)].map((place) => place.split(":")[0]);
    assert.deepEqual(places.sort(), ["first", "second"]);
    await session.ask("continue", { threadId: one });
    assert.equal((await session.stopped("breakpoint")).threadId, one);
    assert.ok(await session.place(other));
  });
});
