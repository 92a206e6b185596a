// The palletiser in a browser: served by `val3 run --serve`, seen and operated.
const assert = require("node:assert/strict");
const { spawn } = require("node:child_process");
const { cpSync, mkdtempSync, readFileSync, rmSync } = require("node:fs");
const { tmpdir } = require("node:os");
const { join } = require("node:path");
const { after, before, test } = require("node:test");
const { chromium } = require("playwright-core");

const FLAGS = ["--no-sandbox", "--use-gl=angle", "--use-angle=swiftshader", "--enable-unsafe-swiftshader"];
const PATIENCE = 20000;

let browser;
before(async () => {
  browser = await chromium.launch({ executablePath: "/usr/bin/chromium", args: FLAGS });
});
after(() => browser.close());

/** The palletiser with its two boxes, served. */
class Served {
  constructor(...options) {
    this.folder = mkdtempSync(join(tmpdir(), "val3-view-"));
    cpSync(join(process.env.VAL3_ROOT, "examples/palletiser"), this.folder, { recursive: true });
    const run = ["run", "usr/usrapp/palletiser", "--serve", "127.0.0.1:0", "--script", "boxes.toml"];
    this.process = spawn(process.env.VAL3_SERVER, [...run, ...options], { cwd: this.folder });
    this.ended = new Promise((resolve) => this.process.on("close", resolve));
    this.faults = [];
  }

  /** The addresses of the page, for operators and guests. */
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

  async open(role = 0) {
    this.pages ??= await this.addresses();
    const page = await browser.newPage({ viewport: { width: 1280, height: 800 } });
    page.setDefaultTimeout(PATIENCE);
    page.on("pageerror", (fault) => this.faults.push(String(fault)));
    page.on("console", (message) => message.type() === "error" && this.faults.push(message.text()));
    await page.goto(this.pages[role]);
    await page.waitForFunction(() => window.val3View?.store.scene.value !== undefined);
    return page;
  }

  /** Ends the run as Ctrl-C does. */
  async end() {
    this.process.stderr.resume();
    this.process.kill("SIGINT");
    await this.ended;
    assert.deepEqual(this.faults, []);
  }

  remove() {
    rmSync(this.folder, { recursive: true });
  }
}

async function served(options, work) {
  const run = new Served(...options);
  try {
    await work(run);
    await run.end();
  } finally {
    run.process.kill();
    run.remove();
  }
}

const now = (page) => page.evaluate(() => window.val3View.store.newest.value);

const until = (page, time) => page.waitForFunction((time) => window.val3View.store.newest.value >= time, time);

test("the arm is seen to move, and its poses are those of the trace", () => served(["--trace", "trace.csv"], async (run) => {
  const page = await run.open();
  const picture = page.locator("canvas").first();
  await until(page, 0.2);
  const still = await picture.screenshot();
  await until(page, 3);
  assert.notDeepEqual(await picture.screenshot(), still);
  await page.evaluate(() => (window.val3View.store.chosen.value = 0));
  await until(page, 6);
  const times = [2.5, 3, 3.504, 4, 4.5, 5.2];
  const poses = await page.evaluate(async (times) => {
    const found = [];
    for (const time of times) {
      window.val3View.store.chosen.value = time;
      found.push(window.val3View.pose());
    }
    return found;
  }, times);
  await run.end();
  const rows = readFileSync(join(run.folder, "trace.csv"), "utf8").trim().split("\n").slice(1).map((row) => row.split(","));
  times.forEach((time, number) => {
    const row = rows.findLast(([t]) => Number(t) <= time + 1e-9);
    const expected = row.slice(9, 12).map(Number);
    const distance = Math.hypot(...expected.map((coordinate, axis) => coordinate - poses[number][axis]));
    assert.ok(distance < 0.002, `${time}: ${poses[number]} instead of ${expected}`);
  });
}));

test("an emergency stop holds the arm", () => served([], async (run) => {
  const page = await run.open();
  await page.getByText("State    running").waitFor();
  const pose = () => page.evaluate(() => window.val3View.pose());
  await until(page, 2);
  const moving = await pose();
  await until(page, 3);
  assert.notDeepEqual(await pose(), moving);
  await page.getByRole("button", { name: "E-stop" }).click();
  await until(page, (await now(page)) + 1);
  const held = await pose();
  await until(page, (await now(page)) + 1);
  assert.deepEqual(await pose(), held);
}));

test("the time is moved back while the run continues", () => served([], async (run) => {
  const page = await run.open();
  await until(page, 3);
  await page.getByRole("slider").first().focus();
  await page.keyboard.press("Home");
  await page.waitForFunction(() => window.val3View.store.time.value === 0);
  assert.ok((await now(page)) >= 3, "the run goes on");
}));

test("a guest looks but does not operate", () => served([], async (run) => {
  const page = await run.open(1);
  assert.equal(await page.evaluate(() => window.val3View.store.scene.value.role), "guest");
  const answer = await page.evaluate(() => window.val3View.store.command("operate", { keys: { power: false } }));
  assert.match(answer.error, /guest/);
}));

test("viewers see the same run", () => served([], async (run) => {
  const pages = [await run.open(0), await run.open(1)];
  await Promise.all(pages.map((page) => until(page, 2)));
  const poses = await Promise.all(pages.map((page) => page.evaluate(() => {
    window.val3View.store.chosen.value = 1.8;
    return window.val3View.pose();
  })));
  assert.deepEqual(poses[0], poses[1]);
}));
