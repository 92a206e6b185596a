// The motion, the inputs and outputs, and the pendant: requests and events `val3/…`.
const assert = require("node:assert/strict");
const { join } = require("node:path");
const { after, before, test } = require("node:test");
const { Application } = require("./application");
const { debug } = require("./session");

const PALLETISER = join(process.env.VAL3_ROOT, "examples/palletiser/usr/usrapp/palletiser");
const ROBOT = { arm: "TX2-60", power: true };

let app;
before(() => {
  app = new Application("moving", {
    data: {
      "joint jFirst": `j1="30" j3="90"`,
      "joint jSecond": `j1="60" j3="70"`,
      "joint jThird": `j1="20" j2="10" j3="80"`,
      "joint jFourth": `j1="-20" j3="90"`,
      "mdesc mRound": `vel="80" leave="60" reach="60" blend="joint"`,
      "mdesc mExact": `vel="80" blend="off"`,
      "num nDone": "",
    },
    programs: `
program start()
begin
  movej(jFirst,flange,mRound)
  movej(jSecond,flange,mRound)
  movej(jThird,flange,mExact)
  movej(jFourth,flange,mRound)
  nDone=1
  waitEndMove()
  nDone=2
end
`,
  });
});
after(() => app.remove());

const line = (text) => app.line("start", text);
const joints = async (session) => (await session.ask("val3/pose")).joints;

test("the arm moves to leave points, to targets without a blend, and to the end of the motion", async () => {
  await debug(app.folder(), { ...ROBOT, stopOnEntry: true, motionMode: "step" }, async (session) => {
    await session.stopped("entry");
    assert.deepEqual(await session.ask("val3/motionMode"), { mode: "step" });
    const queue = async () => (await session.ask("val3/motionQueue")).moves;
    assert.deepEqual(await queue(), []);
    for (const move of ["jFirst", "jSecond"]) {
      await session.run("next", "step");
      const found = (await queue()).at(-1);
      assert.deepEqual([found.type, found.source.line, found.mdesc.leave], ["movej", line(`movej(${move}`), 60]);
      assert.deepEqual(await joints(session), found.leave.joints, `the arm is at the leave point of ${move}`);
      assert.equal(found.leave.distance, 60);
      assert.equal(found.reach, null, "the next move determines it");
    }
    await session.run("next", "step");
    assert.deepEqual(await joints(session), [20, 10, 80, 0, 0, 0]);
    await session.run("next", "step");
    const leave = await joints(session);
    assert.deepEqual(leave, (await queue()).at(-1).leave.joints);
    await session.run("next", "step");
    assert.deepEqual(await joints(session), leave, "a line without motion does not move the arm");
    await session.run("next", "step");
    assert.deepEqual(await joints(session), [-20, 0, 90, 0, 0, 0]);
    assert.deepEqual(await queue(), []);
    // Back to before the line that has cancelled the last blend.
    await session.run("stepBack", "step");
    assert.equal(await session.place(), `start:${line("waitEndMove")}`);
    assert.deepEqual(await joints(session), leave);
  });
});

test("continuing in step mode stops at each line that changes the motion", async () => {
  await debug(app.folder(), { ...ROBOT, stopOnEntry: true, motionMode: "step" }, async (session) => {
    await session.stopped("entry");
    const stops = [];
    for (let number = 0; number < 5; number += 1) stops.push((await session.run("continue", "step")).text);
    const ends = stops.map((text) => /^the arm is at the (\w+) point of move (\d+) of start\(\) line (\d+)/.exec(text).slice(1));
    assert.deepEqual(ends.map(([end]) => end), ["leave", "leave", "target", "leave", "target"]);
    assert.deepEqual(ends.map(([, , at]) => Number(at)), ["jFirst", "jSecond", "jThird", "jFourth", "jFourth"].map((name) => line(`movej(${name}`)));
  });
});

test("pieces of the motion are stepped one by one, also after a change of the mode", async () => {
  const before = (session) => session.setBreakpoints(app.file("start"), line("nDone=1"));
  await debug(app.folder(), { ...ROBOT, before }, async (session) => {
    await session.stopped("breakpoint");
    assert.match(await session.refused("val3/motionStep"), /step mode/);
    assert.match(await session.refused("val3/motionMode", { mode: "fast" }), /fast/);
    await session.ask("val3/motionMode", { mode: "step" });
    const pieces = [];
    for (;;) {
      const answer = await session.ask("val3/motionStep").catch((refusal) => refusal.message);
      if (typeof answer === "string") {
        assert.match(answer, /no further motion/);
        break;
      }
      await session.stopped("step");
      const { piece } = answer;
      assert.deepEqual(await joints(session), piece.joints);
      pieces.push(`${piece.kind} ${piece.end} ${piece.source.line - line("movej(jFirst")}`);
    }
    assert.deepEqual(pieces, [
      "nominal leave 0", "blend reach 0", "nominal leave 1", "blend reach 1", "nominal target 2", "nominal leave 3",
    ]);
    await session.ask("val3/motionMode", { mode: "continuous" });
    await session.setBreakpoints(app.file("start"), line("nDone=2"));
    await session.run("continue", "breakpoint");
    assert.deepEqual(await joints(session), [-20, 0, 90, 0, 0, 0]);
  });
});

test("samples of the arm are subscribed to, with the moving line", async () => {
  const before = async (session) => {
    await session.setBreakpoints(app.file("start"), line("nDone=2"));
    await session.ask("val3/subscribe", { motion: 0.02 });
    assert.match(await session.refused("val3/subscribe", { motion: "often" }), /motion/);
    assert.match(await session.refused("val3/subscribe", { sound: true }), /sound/);
  };
  await debug(app.folder(), { ...ROBOT, before }, async (session) => {
    await session.stopped("breakpoint");
    const samples = session.arrived("val3/motion").flatMap((batch) => batch.samples);
    assert.ok(samples.length > 20, `${samples.length}`);
    const steps = samples.slice(1).map(({ t }, at) => t - samples[at].t);
    assert.ok(steps.every((step) => step > 0.0199), `${Math.min(...steps)}`);
    const moving = new Set(samples.map(({ source }) => source?.line).filter((at) => at !== undefined));
    assert.deepEqual([...moving], [0, 1, 2, 3].map((number) => line("movej(jFirst") + number));
    assert.ok(Math.max(...samples.map(({ speed }) => speed)) > 50);
    const { samples: [{ pose }] } = { samples };
    assert.equal(pose.length, 6);
    await session.ask("val3/subscribe", { motion: false });
    await session.ask("restart");
    await session.stopped("breakpoint");
    assert.deepEqual(session.arrived("val3/motion"), []);
  });
});

test("the robot is operated by hand", async () => {
  await debug(app.folder(), { ...ROBOT, power: false, stopOnEntry: true }, async (session) => {
    await session.stopped("entry");
    await session.ask("val3/operate", { power: true });
    await session.ask("val3/jog", { joints: [5, 0, 90, 0, 0, 0] });
    await session.setBreakpoints(app.file("start"), line("nDone=2"));
    const first = (await session.ask("val3/pose")).joints[0];
    await session.run("continue", "breakpoint");
    assert.notEqual((await session.ask("val3/pose")).joints[0], first);
    assert.match(await session.refused("val3/jog"), /joints/);
    assert.match(await session.refused("val3/jog", { joints: [9999, 0, 0, 0, 0, 0] }), /./);
    assert.match(await session.refused("val3/operate", { dance: true }), /dance/);
  });
});

test("inputs are forced, and changes of outputs are subscribed to", async () => {
  await debug(PALLETISER, { stopOnEntry: true }, async (session) => {
    await session.stopped("entry");
    await session.ask("val3/subscribe", { io: true, userPage: true });
    const signal = async (link) => (await session.ask("val3/io")).signals.find((found) => found.link === link);
    const link = "BasicIO-1\\%I2";
    assert.deepEqual([(await signal(link)).value, (await signal(link)).direction], [0, "input"]);
    await session.ask("val3/ioForce", { link, value: true });
    await session.event("invalidated");
    assert.equal((await signal(link)).value, 1);
    await session.ask("val3/ioForce", { link, lock: true });
    assert.equal((await signal(link)).isLocked, true);
    await session.ask("val3/ioForce", { link, lock: false });
    assert.equal((await signal(link)).isLocked, false);
    assert.match(await session.refused("val3/ioForce", { link: "BasicIO-1\\%I99", value: true }), /%I99/);
    assert.match(await session.refused("val3/ioForce", { link }), /value/);
    assert.match(await session.refused("val3/ioForce", { value: true }), /link/);
    await session.setBreakpoints(join(PALLETISER, "drawScreen.pgx"), { line: 12, hitCondition: "2" });
    await session.run("continue", "breakpoint");
    const changes = session.arrived("val3/io").flatMap((event) => event.changes);
    assert.ok(changes.some(({ link, value }) => link === "BasicIO-1\\%Q4" && value === 1), JSON.stringify(changes));
    const page = await session.ask("val3/userPage");
    assert.deepEqual([page.title, page.lines.length], ["Palletiser", 14]);
    assert.ok(session.arrived("val3/userPage").some(({ title }) => title === "Palletiser"));
    // The key starts the production.
    assert.equal(await session.evaluate("bRun"), "false");
    await session.ask("val3/key", { key: "F1" });
    await session.ask("val3/operate", { power: true });
    await session.setBreakpoints(join(PALLETISER, "drawScreen.pgx"));
    const info = await session.ask("dataBreakpointInfo", { name: "bRun" });
    await session.ask("setDataBreakpoints", { breakpoints: [{ dataId: info.dataId }] });
    assert.match((await session.run("continue", "data breakpoint")).text, /^false -> true \(palletiser:onKey/);
    assert.match(await session.refused("val3/key", { key: "Fire" }), /Fire/);
    assert.match(await session.refused("val3/unknown"), /unknown/);
  });
});
