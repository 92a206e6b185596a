// The page shows the state of the run as programs and the operator meet it: locked inputs, faults, waits, the past.
const assert = require("node:assert/strict");
const { rmSync } = require("node:fs");
const { join } = require("node:path");
const { test } = require("node:test");
const { moveForever, served, setProgram } = require("./served.js");

const status = (page) => page.getByRole("status", { name: "Status" });
const press = (page, name) => page.getByRole("button", { name, exact: true }).click();

test("a locked input shows its locked value, and its button changes it in both directions", () => served([], async (run) => {
  const page = await run.open();
  const value = page.getByRole("button", { name: "%I0 is" }).first();
  await page.getByRole("tab", { name: "Inputs and outputs" }).click();
  await page.getByRole("searchbox").fill("%I0");
  const lock = { name: "Lock BasicIO-1\\%I0", exact: true };
  await page.getByRole("button", lock).click();
  // Before the signal is shown as locked, the button of the value changes the terminal.
  await page.getByRole("button", { ...lock, pressed: true }).waitFor();
  for (const text of ["true", "false", "true"]) {
    await value.click();
    await value.getByText(text, { exact: true }).waitFor();
    await page.waitForFunction((text) => window.val3View.store.panels.cell.page.value.title === text, text);
  }
}, (folder) => setProgram(folder, `
  while true
    if io:diPart==true
      title("true")
    else
      title("false")
    endIf
    delay(0.1)
  endWhile`)));

test("the page says that no arm is named", () => served([], async (run) => {
  const page = await run.open();
  await page.getByText("no arm is named", { exact: true }).waitFor();
  assert.match(await page.locator(".arm").textContent(), /TX2-90/i);
}, (folder) => rmSync(join(folder, "usr/configs/arm.cfx"))));

test("the arm of the cell is stated without a note", () => served([], async (run) => {
  const page = await run.open();
  await page.locator(".arm", { hasText: /TX90L/i }).waitFor();
  assert.equal(await page.getByText("no arm is named").count(), 0);
}));

test("a fault has its code and remedy, and Run starts the application again", () => served([], async (run) => {
  const page = await run.open();
  const bar = page.getByRole("alert", { name: "Fault" });
  await bar.getByText('putln(toString("",1/0))', { exact: true }).waitFor();
  assert.equal(await bar.locator("p").count(), 1, "the remedy");
  await status(page).getByText(/^palletiser~ has failed with error 10 at start:\d+\. Press Run to start the application again\.$/).waitFor();
  setProgram(run.folder, "\n  wait(io:diPart==true)");
  await press(page, "Run");
  await status(page).getByText(/^palletiser~ waits for io:diPart==true at start:\d+\.$/).waitFor();
  assert.equal(await bar.count(), 0);
}, (folder) => setProgram(folder, '\n  delay(0.2)\n  putln(toString("",1/0))')));

test("a refused move shows its reason", () => served(["--power"], async (run) => {
  const page = await run.open();
  await page.getByRole("alert", { name: "Fault" }).getByText(/^movel: .* mm/).waitFor();
}, (folder) => setProgram(folder, `
  pSafe.trsf.x=5000
  movel(pSafe,flange,mFast)`)));

test("a program that waits for the power says so", () => served([], async (run) => {
  const page = await run.open();
  await status(page).getByText(/^The arm has no power\. Switch the power on\. palletiser~ waits for isPowered\(\) at start:\d+\.$/).waitFor();
  await press(page, "Switch power on");
  await status(page).getByText(/^palletiser~ waits for time/).waitFor();
}, (folder) => setProgram(folder, "\n  wait(isPowered())\n  delay(1000)")));

test("a working mode that switches the power off says why the arm stands", () => served(["--power"], async (run) => {
  const page = await run.open();
  await status(page).getByText(/^The arm moves\./).waitFor();
  await page.getByLabel(/mode/i).first().selectOption("manual");
  await status(page).getByText(/^The arm has no power\. Switch the power on\./).waitFor();
}, moveForever));

/** Replaces the code by endless moves and output of the palletiser with power. */
const moveForeverWithPower = (folder) => setProgram(folder, `
  enablePower()
  wait(isPowered())
  while true
    jHome.j1=60
    movej(jHome,tGripper,mFast)
    jHome.j1=-60
    movej(jHome,tGripper,mFast)
    waitEndMove()
  endWhile`);

/** Number of messages and samples by kind, and the state of the page at the end of the run. */
const content = (page) => page.evaluate(() => {
  const { store } = window.val3View;
  const { history, motion, page, state } = store.panels.cell;
  const segments = history.segments.names().map((name) => [name, history.segments.of(name)]);
  return JSON.stringify([
    store.oldest.value, store.newest.value, store.end.value, store.samples.count, [...history.rests()], history.events, history.faults,
    history.states, history.moves.all(), segments, motion.value, page.value, state.value,
  ]);
});

test("a late page operates the present, and has in the end the content of an early one", () => served(["--time", "virtual", "--until", "120"], async (run) => {
  const early = await run.open();
  await early.waitForFunction(() => window.val3View.store.end.value !== undefined);
  const kinds = await early.evaluate(() => new Promise((resolve) => {
    const socket = new WebSocket(new URL("socket", location.href.replace(/^http/, "ws")));
    socket.binaryType = "arraybuffer";
    const kinds = [];
    socket.addEventListener("message", ({ data }) => {
      const message = typeof data === "string" ? JSON.parse(data) : undefined;
      kinds.push(message?.kind ?? new Uint8Array(data)[0]);
      if (message?.kind === "past" && message.from === message.to) {
        socket.close();
        resolve(kinds);
      }
    });
  }));
  const first = kinds.indexOf("past");
  assert.deepEqual([kinds[0], kinds[first + 1], kinds[first + 2], kinds.at(-1)], ["scene", 2, 2, "past"], `${kinds}`);
  assert.ok(kinds.slice(1, first).every((kind) => ["tool", "source", "programs"].includes(kind)), `${kinds}`);
  const late = await run.open();
  await late.waitForFunction(() => window.val3View.store.end.value !== undefined);
  assert.equal(await late.evaluate(() => window.val3View.store.blocked.value), undefined);
  await late.waitForFunction(() => window.val3View.store.past.from.value === undefined && window.val3View.store.oldest.value === 0);
  assert.equal(await content(late), await content(early));
}, moveForeverWithPower));
