// A session with a socket server as in ROS drivers: a client sends positions, each is acknowledged, and the arm never
// moves. The session leads from the wrong value to its cause.
const assert = require("node:assert/strict");
const { writeFileSync } = require("node:fs");
const { join } = require("node:path");
const { after, before, test } = require("node:test");
const { Application } = require("./application");
const { debug } = require("./session");

/** Positions that the client sends, in degrees of axis 1. */
const SENT = [10, 20, 30];

let app, script;
before(() => {
  app = new Application("driver", {
    libraries: {
      queue: {
        data: { "num nPositions[50]": "", "num nLength": "" },
        programs: `
program push(num x_nPosition)
begin
  nPositions[nLength]=x_nPosition
  nLength=nLength+1
end
program clear()
begin
  nLength=0
end
`,
      },
    },
    data: {
      "sio siHost": String.raw`link="Socket\host"`,
      "num nState": "", "num nAcknowledged": "", "bool bReady": "", "joint jNext": `j3="90"`, "mdesc mFast": `vel="100"`,
    },
    programs: `
program start()
begin
  taskCreate "receiver",20,receiver()
  taskCreate "mover",10,mover()
end
program receiver()
  num l_nMessage[2]
begin
  sioCtrl(siHost,"timeout",0)
  while true
    switch nState
      case 0
        if sioGet(siHost,l_nMessage)==2
          nState=1
        endIf
      break
      case 1
        if l_nMessage[0]==11
          call queue:push(l_nMessage[1])
          nState=2
        else
          nState=0
        endIf
      break
      case 2
        sioSet(siHost,l_nMessage)
        nAcknowledged=nAcknowledged+1
        nState=0
      break
    endSwitch
  endWhile
end
program mover()
begin
  enablePower()
  wait(isPowered())
  call prepare()
  while true
    wait(queue:nLength>0)
    jNext.j1=queue:nPositions[0]
    movej(jNext,flange,mFast)
    waitEndMove()
    queue:nLength=queue:nLength-1
  endWhile
end
program prepare()
begin
  // The brakes need some time.
  delay(0.5)
  call queue:clear()
  bReady=true
end
`,
  });
  script = join(app.cell, "client.toml");
  const message = (position) => `receive = { 'Socket\\host' = { bytes = [11, ${position}] } }`;
  writeFileSync(script, SENT.map((position, index) => `[[at]]\nt = ${0.1 * (index + 1)}\n${message(position)}\n`).join(""));
});
after(() => app.remove());

test("a session leads from an arm that never moves to the line that empties the queue", async () => {
  const before = (session) => session.setBreakpoints(app.file("mover"), app.line("mover", "movej("));
  await debug(app.folder(), { script, until: 2, stopOnExit: true, before }, async (session) => {
    // The breakpoint on the move is never reached.
    const stop = await session.stopped("pause");
    assert.match(stop.description, /time limit/);
    const { threads } = await session.ask("threads");
    assert.match(threads[0].name, /^receiver \(priority 20, waits for an input, an output or a serial line \(`sioGet`\)\)$/);
    assert.match(threads[1].name, /^mover \(priority 10, waits for a condition\)$/);
    assert.equal(await session.evaluate("nAcknowledged"), String(SENT.length), "each position was acknowledged");
    assert.equal(await session.evaluate("queue:nLength"), "0", "the wrong value");
    const { breakpoint } = await session.event("breakpoint");
    assert.equal(breakpoint.message, "not hit yet");

    // The writes of the variable name the line.
    const { writes } = await session.ask("val3/history", { name: "queue:nLength" });
    assert.deepEqual(writes.map(({ value }) => value), ["0", "3", "2", "1"]);
    assert.deepEqual(writes.map(({ source }) => source.program), ["clear", "push", "push", "push"]);

    // The run goes back there, and the call stack names the caller.
    await session.watchData("queue:nLength");
    const emptied = await session.run("reverseContinue", "data breakpoint");
    assert.match(emptied.text, new RegExp(`3 -> 0 \\(queue:clear\\(\\), line ${app.line("clear", "nLength=0", "queue")}\\)`));
    await session.run("val3/stepBackInto", "step");
    const frames = await session.frames();
    assert.deepEqual(frames.map(({ name, line, column }) => [name, line, column]), [
      ["queue:clear()", app.line("clear", "nLength=0", "queue"), 3],
      ["driver:prepare()", app.line("prepare", "call queue:clear"), 3],
      ["driver:mover()", app.line("mover", "call prepare"), 3],
    ]);
    await session.run("val3/stepBackOut", "step");
    assert.deepEqual([await session.place(), await session.evaluate("queue:nLength")], [`prepare:${app.line("prepare", "call queue:clear")}`, "3"]);
    const pushed = await session.run("reverseContinue", "data breakpoint");
    assert.match(pushed.text, /^2 -> 3 \(queue:push\(\)/);

    // The repair is tried in this past: without the clearing, the arm moves.
    await session.run("continue", "data breakpoint");
    await session.ask("setDataBreakpoints", { breakpoints: [] });
    await session.evaluate("queue:nLength=3", "repl");
    await session.run("continue", "breakpoint");
    assert.deepEqual([await session.place(), await session.evaluate("jNext.j1")], [`mover:${app.line("mover", "movej(")}`, "10"]);
    await session.run("next", "step");
    await session.run("next", "step");
    assert.equal(Math.round((await session.ask("val3/pose")).joints[0]), 10, "the arm has moved");
  });
});
