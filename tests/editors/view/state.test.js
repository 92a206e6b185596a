// The page shows the state of the run as programs and the operator meet it: locked inputs, faults, waits, the past.
const assert = require("node:assert/strict");
const { test } = require("node:test");
const { served, setProgram } = require("./served.js");

const status = (page) => page.getByRole("status", { name: "Status" });
const press = (page, name) => page.getByRole("button", { name, exact: true }).click();

test("a locked input shows its locked value, and its button changes it in both directions", () => served([], async (run) => {
  const page = await run.open();
  const value = page.getByRole("button", { name: "%I0 is" }).first();
  await page.getByRole("tab", { name: "Inputs and outputs" }).click();
  await page.getByRole("searchbox").fill("%I0");
  await page.getByRole("button", { name: "Lock BasicIO-1\\%I0", exact: true }).click();
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

test("a late page reads the past before it operates", () => served(["--time", "virtual", "--until", "60"], async (run) => {
  const early = await run.open();
  await early.waitForFunction(() => window.val3View.store.end.value !== undefined);
  const counts = await early.evaluate(() => new Promise((resolve) => {
    const socket = new WebSocket(new URL("socket", location.href.replace(/^http/, "ws")));
    const counts = [];
    let received = 0;
    socket.addEventListener("message", ({ data }) => {
      const { kind, messages } = typeof data === "string" ? JSON.parse(data) : {};
      if (kind !== "past") {
        received += 1;
      } else if (counts.push(messages, received) === 4) {
        socket.close();
        resolve(counts);
      }
    });
  }));
  assert.ok(counts[0] > 100 && counts[1] === 0 && counts[2] === 0 && counts[3] >= counts[0], `${counts}`);
  const late = await run.open();
  await late.waitForFunction(() => window.val3View.store.end.value !== undefined && window.val3View.store.past.value === undefined);
}, (folder) => setProgram(folder, `
  enablePower()
  wait(isPowered())
  while true
    jHome.j1=60
    movej(jHome,tGripper,mFast)
    jHome.j1=-60
    movej(jHome,tGripper,mFast)
    waitEndMove()
  endWhile`)));
