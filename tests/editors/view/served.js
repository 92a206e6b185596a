// The palletiser, served by `val3 run --serve`, and the browser that shows it.
const assert = require("node:assert/strict");
const { spawn } = require("node:child_process");
const { cpSync, mkdtempSync, readFileSync, rmSync, writeFileSync } = require("node:fs");
const { tmpdir } = require("node:os");
const { join } = require("node:path");
const { after, before } = require("node:test");
const { launch, TIMEOUT } = require("../../../editors/view/test/chromium.js");

/** Number of attempts to hold a button before the test fails. */
const PRESSES = 6;

/** Window of the pages. */
const DESKTOP = { viewport: { width: 1280, height: 800 } };

let browser;
before(async () => {
  browser = await launch();
});
after(() => browser.close());

/** The palletiser with its two boxes, served. */
class Served {
  constructor(options, prepare, secret) {
    this.folder = mkdtempSync(join(tmpdir(), "val3-view-"));
    cpSync(join(process.env.VAL3_ROOT, "examples/palletiser"), this.folder, { recursive: true });
    prepare(this.folder);
    this.options = options;
    this.environment = secret === undefined ? process.env : { ...process.env, VAL3_SERVE_SECRET: secret };
    this.faults = [];
    this.opened = [];
    this.hasEnded = false;
    this.start("127.0.0.1:0");
  }

  start(address) {
    this.process = spawn(process.env.VAL3_SERVER, ["run", "usr/usrapp/palletiser", "--serve", address, ...this.options], { cwd: this.folder, env: this.environment });
    this.ended = new Promise((resolve) => this.process.on("close", resolve));
  }

  /** Starts the server again on its port, after its end. Returns the new addresses of the page. */
  async restart() {
    this.start(new URL(this.pages[0]).host);
    this.pages = await this.addresses();
    return this.pages;
  }

  /** Returns the addresses of the page, for operators and guests. */
  async addresses() {
    let output = "";
    for await (const bytes of this.process.stderr) {
      output += bytes;
      const found = output.match(/http:\S+\n/g) ?? [];
      if (found.length === 2) {
        return found.map((address) => address.trim());
      }
    }
    throw new Error(`The run has ended: ${output}`);
  }

  /** Opens the page of operators or guests, in a window of the default size, or in a device with these properties. */
  async open(role = 0, device = DESKTOP) {
    this.pages ??= await this.addresses();
    const page = await browser.newPage(device);
    this.opened.push(page);
    page.setDefaultTimeout(TIMEOUT);
    page.on("pageerror", (fault) => this.faults.push(String(fault)));
    // A page tries to connect again after the end of its server.
    page.on("console", (message) => message.type() === "error" && !this.hasEnded && this.faults.push(message.text()));
    await page.goto(this.pages[role]);
    await page.waitForFunction(() => window.val3View?.store.scene.value !== undefined);
    return page;
  }

  /** Ends the run as Ctrl-C does. */
  async end() {
    this.process.stderr.resume();
    this.hasEnded = true;
    this.process.kill("SIGINT");
    await this.ended;
    assert.deepEqual(this.faults, []);
  }

  /** Ends the process, closes the pages and removes the folder. An open page would slow down the next test. */
  async remove() {
    this.hasEnded = true;
    this.process.kill();
    await Promise.all(this.opened.map((page) => page.close()));
    rmSync(this.folder, { recursive: true });
  }
}

/** Replaces the code of the program `start` of the palletiser in a folder, between `begin` and `end`. */
function setProgram(folder, code) {
  const file = join(folder, "usr/usrapp/palletiser/start.pgx");
  writeFileSync(file, readFileSync(file, "latin1").replace(/begin[^]*end(?=\s*\]\]>)/, `begin${code}\nend`), "latin1");
}

/** Replaces the program by an endless sequence of moves, because the palletiser is idle after its last box. */
const moveForever = (folder) => setProgram(folder, `
  while true
    jHome.j1=60
    movej(jHome,tGripper,mFast)
    jHome.j1=-60
    movej(jHome,tGripper,mFast)
    waitEndMove()
  endWhile`);

/** Serves the palletiser, after `prepare` has changed its folder, and calls `work` with it. A random secret is the default. */
async function served(options, work, prepare = () => undefined, secret = undefined) {
  const run = new Served(options, prepare, secret);
  try {
    await work(run);
    await run.end();
  } finally {
    await run.remove();
  }
}

const now = (page) => page.evaluate(() => window.val3View.store.newest.value);

const until = (page, time) => page.waitForFunction((time) => window.val3View.store.newest.value >= time, time);

/**
 * Holds a button with the mouse until `arrived` is true in the page. Before the press, the layout may move the button
 * away from the mouse, so that a missed press is repeated.
 */
async function hold(page, button, arrived, argument) {
  const held = button.locator("xpath=parent::*[contains(@class, 'held')]");
  let isHeld = false;
  for (let attempt = 0; attempt < PRESSES && !isHeld; attempt += 1) {
    await page.mouse.up();
    await button.hover();
    await page.mouse.down();
    isHeld = await held.waitFor({ timeout: TIMEOUT / PRESSES }).then(() => true, () => false);
  }
  assert.ok(isHeld, "the button can be held");
  await page.waitForFunction(arrived, argument).catch(async (fault) => {
    throw new Error(`${fault.message} ${await handState(page, held)}`, { cause: fault });
  });
  await page.mouse.up();
}

/** Describes the states of a held button and the arm. */
async function handState(page, held) {
  const isHeld = await held.count() > 0;
  const notices = await page.locator(".notice").allInnerTexts();
  const cell = await page.evaluate(() => {
    const { blocked, end, isPaused, panels: { cell: { sample, state } } } = window.val3View.store;
    return { blocked: blocked.value, end: end.value, isPaused: isPaused.value, joints: sample.value?.joints, mode: state.value?.mode, power: state.value?.power };
  });
  return JSON.stringify({ isHeld, notices, ...cell });
}

/** Waits until the arm is at joints, each within a distance in degrees or mm. */
async function isAt(page, joints, most) {
  await page.waitForFunction(({ joints, most }) => joints.every((joint, axis) => Math.abs(joint - window.val3View.store.panels.cell.sample.value.joints[axis]) < most), { joints, most });
}

/** Moves the arm by hand until all axes have arrived. */
async function jogTo(page, joints) {
  await page.evaluate((jog) => window.val3View.store.command("operate", { keys: { jog } }), joints);
  await isAt(page, joints, 1e-6);
}

/** Opens a page that needs no server. */
async function openFile(path) {
  const page = await browser.newPage(DESKTOP);
  page.setDefaultTimeout(TIMEOUT);
  await page.goto(`file://${path}`);
  return page;
}

const BOXES = ["--script", "boxes.toml"];

module.exports = { BOXES, hold, isAt, jogTo, moveForever, now, openFile, served, setProgram, until };
