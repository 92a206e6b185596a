// The tab Program: the executed line and the line of the present move, also in the past, after a fault and in an export.
const assert = require("node:assert/strict");
const { spawnSync } = require("node:child_process");
const { cpSync, mkdtempSync, readFileSync, rmSync, statSync } = require("node:fs");
const { createRequire } = require("node:module");
const { tmpdir } = require("node:os");
const { join } = require("node:path");
const { test } = require("node:test");
const { BOXES, moveForever, openFile, served, setProgram } = require("./served.js");

const axe = readFileSync(createRequire(join(process.env.VAL3_ROOT, "editors/view/test/browser.mjs")).resolve("axe-core/axe.min.js"), "utf8");

const openTab = (page) => page.getByRole("tab", { name: "Program", exact: true }).click();
const code = (page) => page.getByRole("region", { name: /^Code of / });
const row = (page, text) => code(page).locator("tr").filter({ hasText: text });

/** Takes a screenshot, and checks the accessibility of the page. */
async function check(page, name) {
  await page.screenshot({ path: join(process.env.VAL3_OUTPUT, `program-${name}.png`) });
  await page.evaluate(axe);
  const { violations } = await page.evaluate(() => window.axe.run());
  assert.deepEqual(violations.map(({ id, nodes }) => `${id}: ${nodes[0].html}`), [], name);
}

/** Returns a time at which the arm executes a move with these properties, from the samples of the page. */
const timeOfMove = (page, wanted) => page.evaluate((wanted) => {
  const { samples, sources } = window.val3View.store;
  const isWanted = (source) => source !== undefined && Object.entries(wanted).every(([name, value]) => source[name] === value);
  const times = [...samples.after(0)].filter(({ source }) => isWanted(sources.get(source))).map(({ t }) => t);
  return times[Math.floor(times.length / 2)];
}, wanted);

const seek = (page, t) => page.evaluate((t) => { window.val3View.store.chosen.value = t; }, t);

test("the executed line and the line of the present move are marked, also in the past", () => served(["--power"], async (run) => {
  const page = await run.open();
  await openTab(page);
  await row(page, "waitEndMove()").and(page.locator(".at")).getByText("palletiser~ waits", { exact: true }).waitFor();
  await page.waitForFunction(() => [...document.querySelectorAll(".code-table tr.moving")].some((row) => row.textContent.includes("movej(")));
  const [first, second] = await code(page).locator("tr").filter({ hasText: "movej(" }).locator(".line-number").allInnerTexts();
  await page.waitForFunction((line) => document.querySelector(".code-table tr.moving .line-number")?.textContent === line, second);
  for (const line of [first, second, first]) {
    await seek(page, await timeOfMove(page, { line: Number(line) }));
    await page.waitForFunction((line) => document.querySelector(".code-table tr.moving .line-number")?.textContent === line, line);
  }
  await seek(page, 0);
  await row(page, "begin").waitFor();
  assert.equal(await page.locator(".code-table tr.moving").count(), 0, "no move at the beginning");
  await check(page, "past");
}, moveForever));

test("the calling lines lead to their programs, and libraries are listed", () => served(BOXES, async (run) => {
  const page = await run.open();
  await openTab(page);
  const calls = page.getByRole("navigation", { name: "Calls" });
  const picks = await page.waitForFunction(() => window.val3View.store.panels.cell.history.states.find(({ tasks }) => tasks.some(({ program, callers }) => program === "pick" && callers.length === 2)));
  await seek(page, (await picks.jsonValue()).t);
  await page.waitForFunction(() => document.querySelectorAll(".call-path li").length === 3);
  const [outer] = await calls.getByRole("button").allInnerTexts();
  assert.match(outer, /^production:\d+$/);
  await calls.getByRole("button").first().click();
  await page.getByRole("region", { name: "Code of production" }).waitFor();
  await page.locator(".code-table tr.opened").getByText("call cycle(").waitFor();
  const follow = page.getByRole("button", { name: "Follow the execution" });
  assert.equal(await follow.getAttribute("aria-pressed"), "false");
  const programs = page.getByRole("combobox", { name: "Program" });
  const groups = await programs.locator("optgroup").evaluateAll((all) => all.map(({ label }) => label));
  // libLoad has loaded partBox during the run. The library io has no programs.
  assert.deepEqual(groups, ["palletiser", "partBox"]);
  await programs.selectOption({ label: "average" });
  await page.getByRole("region", { name: "Code of average" }).getByText("// Mean of a list of times in seconds").waitFor();
  await follow.click();
  await page.getByRole("region", { name: "Code of average" }).waitFor({ state: "detached" });
  await page.getByRole("combobox", { name: "Followed task" }).selectOption({ label: "Arm (present move)" });
  await seek(page, await timeOfMove(page, { instruction: "movel" }));
  await page.locator(".code-table tr.moving").getByText("movel(").waitFor();
  for (const [width, height] of [[1280, 800], [390, 844]]) {
    await page.setViewportSize({ width, height });
    await page.waitForFunction(() => {
      const [row, box] = [".code-table tr.moving", ".code-box"].map((part) => document.querySelector(part)?.getBoundingClientRect());
      return row !== undefined && row.top >= box.top && row.bottom <= box.bottom;
    });
    assert.ok(await page.locator(".picture").evaluate((picture) => picture.clientWidth > 300 && picture.clientHeight > 200), "the picture stays");
    await check(page, `calls-${width}`);
  }
}));

test("a fault opens its line", () => served([], async (run) => {
  const page = await run.open();
  const bar = page.getByRole("alert", { name: "Fault" });
  await bar.getByRole("button", { name: "Open the line" }).click();
  await page.getByRole("tab", { name: "Program", selected: true }).waitFor();
  const line = page.locator(".code-table tr.opened");
  await line.getByText('putln(toString("",1/0))').waitFor();
  await line.getByText("palletiser~: error 10", { exact: true }).waitFor();
  await check(page, "fault");
  await page.getByRole("tab", { name: /^Tasks/ }).click();
  await page.getByRole("button", { name: /^start:\d+$/ }).first().click();
  await page.locator(".code-table tr.opened").waitFor();
}, (folder) => setProgram(folder, '\n  delay(0.2)\n  putln(toString("",1/0))')));

test("a program with 5,000 lines scrolls to the executed line", () => served([], async (run) => {
  const page = await run.open();
  await openTab(page);
  await row(page, "delay(1000)").and(page.locator(".at")).waitFor();
  assert.ok(await code(page).evaluate((box) => box.scrollTop > 90_000), "the end of the program");
  assert.ok(await code(page).locator("tr").count() < 80, "only lines on the screen are drawn");
  await code(page).hover();
  await page.mouse.wheel(0, -200_000);
  await row(page, "begin").waitFor();
  assert.equal(await page.getByRole("button", { name: "Follow the execution" }).getAttribute("aria-pressed"), "false");
}, (folder) => setProgram(folder, `${"\n  nState=0".repeat(5000)}\n  delay(1000)`)));

test("an export contains the programs", async () => {
  const folder = mkdtempSync(join(tmpdir(), "val3-export-"));
  try {
    cpSync(join(process.env.VAL3_ROOT, "examples/palletiser"), folder, { recursive: true });
    const { status, stderr } = spawnSync(process.env.VAL3_SERVER, ["run", "usr/usrapp/palletiser", ...BOXES, "--until", "20", "--export", "run.html"], { cwd: folder, encoding: "utf8" });
    assert.ok(status === 0 || status === 3, stderr);
    assert.ok(statSync(join(folder, "run.html")).size < 3_000_000);
    const page = await openFile(join(folder, "run.html"));
    await page.waitForFunction(() => window.val3View?.store.end.value !== undefined);
    await page.getByRole("button", { name: "Panels" }).click();
    await openTab(page);
    await page.getByRole("combobox", { name: "Followed task" }).selectOption({ label: "Arm (present move)" });
    await seek(page, await timeOfMove(page, { instruction: "movel" }));
    await page.locator(".code-table tr.moving").getByText("movel(").waitFor();
    await check(page, "export");
    await page.close();
  } finally {
    rmSync(folder, { recursive: true });
  }
});
