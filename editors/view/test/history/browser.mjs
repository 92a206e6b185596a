// The page of a variable's history in a browser: list, plot, keyboard, axe-core, thousands of writes, and screenshots in
// three looks. Arguments: the folder of playwright-core, and optionally a folder for screenshots. VAL3_CHROMIUM names
// another browser.
import assert from "node:assert/strict";
import { mkdirSync, readFileSync } from "node:fs";
import { createRequire } from "node:module";
import { join } from "node:path";
import { pathToFileURL } from "node:url";
import { buildSync } from "esbuild";

const [playwright, pictures] = process.argv.slice(2);
const require = createRequire(import.meta.url);
const { chromium } = require(playwright);
const axe = readFileSync(require.resolve("axe-core/axe.min.js"), "utf8");
const PAGE = pathToFileURL(join(import.meta.dirname, "../../dist/history.html")).href;
const { outputFiles: [{ text }] } = buildSync({ entryPoints: [join(import.meta.dirname, "sample.ts")], bundle: true, write: false, format: "esm" });
const { counts, history, inputs, joints, jointTable, NUMBER, points, texts, textTable, write } = await import(`data:text/javascript;base64,${Buffer.from(text).toString("base64")}`);
if (pictures !== undefined) {
  mkdirSync(pictures, { recursive: true });
}

/** Colours of VS Code's high contrast theme. */
const CONTRAST = { "--vscode-foreground": "#ffffff", "--vscode-editor-background": "#000000", "--vscode-contrastBorder": "#6fc3df", "--vscode-contrastActiveBorder": "#f38518", "--vscode-focusBorder": "#f38518",
  "--vscode-descriptionForeground": "#ffffffb3", "--vscode-charts-blue": "#3794ff", "--vscode-charts-orange": "#d18616", "--vscode-charts-green": "#89d185", "--vscode-charts-purple": "#b180d7", "--vscode-charts-red": "#f48771", "--vscode-charts-yellow": "#cca700" };

const browser = await chromium.launch({ executablePath: process.env.VAL3_CHROMIUM ?? "/usr/bin/chromium", args: ["--no-sandbox"] });
let checks = 0;

async function open(shown, theme = "light", size = { width: 1280, height: 800 }) {
  const context = await browser.newContext({ viewport: size, colorScheme: theme === "light" ? "light" : "dark" });
  const page = await context.newPage();
  page.on("pageerror", (error) => assert.fail(error));
  page.on("dialog", () => assert.fail("a value was executed"));
  await page.addInitScript(() => {
    globalThis.sent = [];
    globalThis.acquireVsCodeApi = () => ({ postMessage: (message) => globalThis.sent.push(message) });
  });
  await page.goto(PAGE);
  if (theme === "contrast") {
    await page.evaluate((colours) => {
      document.body.className = "vscode-high-contrast";
      Object.entries(colours).forEach(([name, value]) => document.documentElement.style.setProperty(name, value));
    }, CONTRAST);
  }
  await post(page, { kind: "history", history: shown });
  await page.waitForSelector("[role=grid]");
  return page;
}

const post = (page, message) => page.evaluate((message) => globalThis.postMessage(message, "*"), message);
const sent = (page) => page.evaluate(() => globalThis.sent.splice(0));
const selected = (page) => page.locator("tr[aria-selected=true]").innerText();
const spoken = (page) => page.locator("[role=slider]").getAttribute("aria-valuetext");

async function check(page, name) {
  await page.waitForTimeout(200);
  if (pictures !== undefined) {
    await page.screenshot({ path: join(pictures, `${name}.png`) });
  }
  await page.evaluate(axe);
  const { violations } = await page.evaluate(() => globalThis.axe.run());
  const found = violations.map(({ id, impact, nodes }) => `${id} (${impact}): ${nodes.map(({ html }) => html.slice(0, 160)).join("; ")}`);
  assert.deepEqual(found, [], name);
  checks += 1;
}

/** Returns the number of pixels of the plot that are not transparent, between two heights from 0 to 1. */
const inked = (page, from = 0, to = 1) => page.evaluate(([from, to]) => {
  const canvas = document.querySelector("canvas");
  const [top, height] = [Math.round(canvas.height * from), Math.round(canvas.height * (to - from))];
  return canvas.getContext("2d").getImageData(0, top, canvas.width, height).data.filter((value, index) => index % 4 === 3 && value > 0).length;
}, [from, to]);

/** Returns the median time from a key until the page is drawn, in ms. */
const keyTime = (page) => page.evaluate(async () => {
  const times = [];
  for (let key = 0; key < 20; key += 1) {
    const start = performance.now();
    document.activeElement.dispatchEvent(new KeyboardEvent("keydown", { key: key % 2 === 0 ? "PageDown" : "PageUp", bubbles: true }));
    await new Promise((resolve) => requestAnimationFrame(() => setTimeout(resolve)));
    times.push(performance.now() - start);
  }
  return times.sort((left, right) => left - right)[10];
});

for (const theme of ["light", "dark", "contrast"]) {
  for (const [name, shown] of [["number", counts(60)], ["joint", joints()], ["point", points()], ["input", inputs()], ["text", texts()]]) {
    const page = await open(shown, theme);
    if (name !== "text") {
      assert.ok(await inked(page) > 1000, `${name}: nothing is plotted`);
      await page.hover("[role=slider]", { position: { x: 400, y: 300 } });
      await page.waitForSelector(".hint");
    }
    await check(page, `history-${name}-${theme}`);
    await page.context().close();
  }
  const page = await open(points(), theme, { width: 390, height: 844 });
  await page.click("button:text-is('rx')");
  await check(page, `history-narrow-${theme}`);
  await page.context().close();
}

// Tables of arrays. Only the visible rows are in the document.
for (const theme of ["light", "dark", "contrast"]) {
  const page = await open(joints(), theme);
  await post(page, { kind: "table", table: jointTable(10_000, 5) });
  await page.waitForSelector("[role=region]");
  assert.deepEqual(await page.locator("th").allInnerTexts(), ["Index", "j1 (°)", "j2 (°)", "j3 (°)", "j4 (°)", "j5 (°)", "j6 (°)"]);
  assert.ok(await page.locator("tbody tr").count() < 100);
  assert.match(await page.locator("header").innerText(), /the first 10000 of 10005 elements/);
  await check(page, `table-joints-${theme}`);
  await page.locator("[role=region]").focus();
  await page.keyboard.press("End");
  await page.waitForSelector("td:text-is('[9999]')");
  await sent(page);
  await page.click("button:text-is('Show more elements')");
  assert.deepEqual(await sent(page), [{ command: "more" }]);
  await post(page, { kind: "table", table: textTable() });
  await page.waitForSelector("text=<img src=x");
  assert.equal(await page.locator("button").count(), 0);
  await check(page, `table-text-${theme}`);
  await page.context().close();
}

// The list, with the keyboard.
const page = await open(joints());
assert.deepEqual(await sent(page), [{ command: "ready" }]);
assert.equal(await page.locator("[role=grid]").getAttribute("aria-rowcount"), "26");
assert.match(await selected(page), /^9\.400 s\t\{.*\}\tstart:7\tmain~$/);
await page.locator("[role=grid]").focus();
await page.keyboard.press("ArrowDown");
assert.match(await selected(page), /^9\.000 s/);
assert.match(await spoken(page), /9\.000 s, start:7$/);
await page.keyboard.press("Enter");
assert.deepEqual((await sent(page)).map(({ command, isFinal, source }) => [command, isFinal, source.line]), [["openLine", true, 7]]);
await page.keyboard.press("End");
assert.match(await selected(page), /^0\.000 s\t.*\tbefore these writes/);
await page.keyboard.press("Enter");
assert.deepEqual(await sent(page), [], "the value before all writes has no line");
await page.locator("tr", { hasText: "0.600 s" }).click();
assert.deepEqual((await sent(page)).map(({ command, isFinal }) => [command, isFinal]), [["openLine", false]]);

// The plot, with the keyboard and the mouse.
await page.locator("[role=slider]").focus();
await page.keyboard.press("ArrowRight");
assert.match(await spoken(page), /1\.000 s, start:7$/);
const area = await page.locator("[role=slider]").boundingBox();
await page.mouse.click(area.x + 72 + (area.width - 82) / 2, area.y + 40);
assert.match(await selected(page), /^4\.600 s/);
await page.keyboard.press("+");
await page.waitForTimeout(50);
const narrow = await inked(page);
await page.keyboard.press("0");
await page.waitForTimeout(50);
assert.notEqual(await inked(page), narrow);
for (const axis of ["j1", "j2", "j3", "j4", "j5", "j6"]) {
  await page.click(`button:text-is("${axis}")`);
}
await page.getByText("Choose a number above to plot it.").waitFor();
await page.click('button:text-is("j3")');

// The run goes back, and then has other writes.
await post(page, { kind: "note", note: "The run continues." });
await page.getByText("The run continues.").waitFor();
const before = joints();
await post(page, { kind: "history", history: { ...before, writes: before.writes.slice(12), now: 4.7 } });
await page.getByText("present: 4.700 s").waitFor();
assert.equal(await page.getByText("The run continues.").count(), 0);
assert.equal(await page.locator('button[aria-pressed="true"]').innerText(), "j3");
await check(page, "history-past");
await page.context().close();

// Thousands of writes: few rows in the document, and a key is answered at once.
const long = await open({ ...counts(20_000), more: true, initial: null, initialNumbers: null, since: null });
assert.ok(await long.locator("[role=grid] tr").count() < 60);
await long.locator("[role=grid]").focus();
const few = await open(counts(200));
await few.locator("[role=grid]").focus();
const [short, many] = [await keyTime(few), await keyTime(long)];
// Other processes of the machine slow down both.
assert.ok(many < 3 * short + 60, `a key takes ${many} ms, with 200 writes ${short} ms`);
console.log(`20,000 writes: a key takes ${many.toFixed(0)} ms, with 200 writes ${short.toFixed(0)} ms (medians of 20)`);
await few.context().close();
await long.click("text=Show earlier writes");
assert.deepEqual((await sent(long)).at(-1), { command: "more" });
await check(long, "history-long");
await long.context().close();

// A value that is not in memory, and a number that is not finite, are gaps.
const gaps = await open(history("num", NUMBER, [write(1, [5]), write(2, [null], { value: "infinity" }), write(4, [7]), write(6, [], { value: "not in memory" })]));
await check(gaps, "history-gaps");

await browser.close();
console.log(`test result: ok. ${checks} passed; 0 failed; history in the browser`);
