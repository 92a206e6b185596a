// The page of a variable's history in a browser: list, plot, keyboard, axe-core, thousands of writes, and screenshots in
// three looks.
import assert from "node:assert/strict";
import { join } from "node:path";
import { test } from "node:test";
import { buildSync } from "esbuild";
import { bundle, check, eventually, expectSent, open } from "../browser.mjs";

const { outputFiles: [{ text }] } = buildSync({ entryPoints: [join(import.meta.dirname, "sample.ts")], bundle: true, write: false, format: "esm" });
const { counts, history, inputs, joints, jointTable, NUMBER, points, texts, textTable, write } = await import(`data:text/javascript;base64,${Buffer.from(text).toString("base64")}`);

/** Colours of VS Code's high contrast theme. */
const CONTRAST = { "--vscode-foreground": "#ffffff", "--vscode-editor-background": "#000000", "--vscode-contrastBorder": "#6fc3df", "--vscode-contrastActiveBorder": "#f38518", "--vscode-focusBorder": "#f38518",
  "--vscode-descriptionForeground": "#ffffffb3", "--vscode-charts-blue": "#3794ff", "--vscode-charts-orange": "#d18616", "--vscode-charts-green": "#89d185", "--vscode-charts-purple": "#b180d7", "--vscode-charts-red": "#f48771", "--vscode-charts-yellow": "#cca700" };

const fakeEditor = (page) => page.addInitScript(() => {
  globalThis.sent = [];
  globalThis.acquireVsCodeApi = () => ({ postMessage: (message) => globalThis.sent.push(message) });
});

async function openHistory(context, shown, theme, size) {
  const page = await open(context, bundle("history.html"), { theme, size, prepare: fakeEditor });
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
const matches = (locator, expected) => eventually(async () => assert.match(await locator.innerText(), expected));
const selected = (page) => page.locator("tr[aria-selected=true]");
const expectSpoken = (page, expected) => eventually(async () => assert.match(await page.locator("[role=slider]").getAttribute("aria-valuetext"), expected));
const line = ({ command, isFinal, source }) => (command === "openLine" ? [[isFinal, source.line]] : []);

/** Returns the number of pixels of the plot that are not transparent. */
const inked = (page) => page.evaluate(() => {
  const canvas = document.querySelector("canvas");
  return canvas.getContext("2d").getImageData(0, 0, canvas.width, canvas.height).data.filter((value, index) => index % 4 === 3 && value > 0).length;
});

for (const theme of ["light", "dark", "contrast"]) {
  test(`values of all types, ${theme}`, async (context) => {
    for (const [name, shown] of [["number", counts(60)], ["joint", joints()], ["point", points()], ["input", inputs()], ["text", texts()]]) {
      const page = await openHistory(context, shown, theme);
      if (name !== "text") {
        await eventually(async () => assert.ok(await inked(page) > 1000, `${name}: nothing is plotted`));
        await page.hover("[role=slider]", { position: { x: 400, y: 300 } });
        await page.waitForSelector(".hint");
      }
      await check(page, `history-${name}-${theme}`);
      await page.close();
    }
    const page = await openHistory(context, points(), theme, { width: 390, height: 844 });
    await page.click("button:text-is('rx')");
    await check(page, `history-narrow-${theme}`);
  });
}

for (const theme of ["light", "dark", "contrast"]) {
  test(`arrays as tables, ${theme}`, async (context) => {
    const page = await openHistory(context, joints(), theme);
    await post(page, { kind: "table", table: jointTable(10_000, 5) });
    await page.waitForSelector("[role=region]");
    assert.deepEqual(await page.locator("th").allInnerTexts(), ["Index", "j1 (°)", "j2 (°)", "j3 (°)", "j4 (°)", "j5 (°)", "j6 (°)"]);
    // Only the visible rows are in the document.
    assert.ok(await page.locator("tbody tr").count() < 100);
    assert.match(await page.locator("header").innerText(), /the first 10000 of 10005 elements/);
    await eventually(async () => assert.ok(await inked(page) > 1000, "nothing is plotted"));
    assert.equal(await page.locator("section button[aria-pressed=true]").count(), 6);
    await check(page, `table-joints-${theme}`);
    await page.click("button:text-is('j2')");
    assert.equal(await page.locator("section button[aria-pressed=true]").count(), 5);
    await page.locator("[role=slider]").focus();
    await page.keyboard.press("Home");
    await page.keyboard.press("ArrowRight");
    await expectSpoken(page, /^\[1\], \{/);
    await matches(page.locator("tr.selected"), /^\[1\]\t/);
    await page.locator("[role=region]").focus();
    await page.keyboard.press("End");
    await page.waitForSelector("td:text-is('[9999]')");
    await page.click("button:text-is('Show more elements')");
    await expectSent(page, [{ command: "ready" }, { command: "more" }]);
    await post(page, { kind: "table", table: textTable() });
    await page.waitForSelector("text=<img src=x");
    assert.equal(await page.locator("button").count(), 0);
    await check(page, `table-text-${theme}`);
  });
}

/** Counts the drawn pixels of the plot as soon as its drawing stays the same for some frames. */
async function settledInk(page) {
  let [before, equal] = [await inked(page), 0];
  while (equal < 3) {
    await page.evaluate(() => new Promise((resolve) => { requestAnimationFrame(() => requestAnimationFrame(resolve)); }));
    const now = await inked(page);
    [before, equal] = [now, now === before ? equal + 1 : 0];
  }
  return before;
}

test("list and plot follow the keyboard and the mouse", async (context) => {
  const page = await openHistory(context, joints());
  await expectSent(page, [{ command: "ready" }]);
  assert.equal(await page.locator("[role=grid]").getAttribute("aria-rowcount"), "26");
  await matches(selected(page), /^9\.400 s\t\{.*\}\tstart:7\tmain~$/);
  await page.locator("[role=grid]").focus();
  await page.keyboard.press("ArrowDown");
  await matches(selected(page), /^9\.000 s/);
  await expectSpoken(page, /9\.000 s, start:7$/);
  await page.keyboard.press("Enter");
  await expectSent(page, [[true, 7]], line);
  await page.keyboard.press("End");
  await matches(selected(page), /^0\.000 s\t.*\tbefore these writes/);
  // The value before all writes has no line: of the two actions, only the second one opens one.
  await page.keyboard.press("Enter");
  await page.locator("tr", { hasText: "0.600 s" }).click();
  await expectSent(page, [[false, 7]], line);
  await page.locator("[role=slider]").focus();
  await page.keyboard.press("ArrowRight");
  await expectSpoken(page, /1\.000 s, start:7$/);
  const area = await page.locator("[role=slider]").boundingBox();
  await page.mouse.click(area.x + 72 + (area.width - 82) / 2, area.y + 40);
  await matches(selected(page), /^4\.600 s/);
  const whole = await settledInk(page);
  await page.keyboard.press("+");
  await eventually(async () => assert.notEqual(await inked(page), whole));
  await page.keyboard.press("0");
  await eventually(async () => assert.equal(await inked(page), whole));
});

test("the run goes back, and then has other writes", async (context) => {
  const page = await openHistory(context, joints());
  for (const axis of ["j1", "j2", "j3", "j4", "j5", "j6"]) {
    await page.click(`button:text-is("${axis}")`);
  }
  await page.getByText("Choose a number above to plot it.").waitFor();
  await page.click('button:text-is("j3")');
  await post(page, { kind: "note", note: "The run continues." });
  await page.getByText("The run continues.").waitFor();
  const before = joints();
  await post(page, { kind: "history", history: { ...before, writes: before.writes.slice(12), now: 4.7 } });
  await page.getByText("present: 4.700 s").waitFor();
  await page.getByText("The run continues.").waitFor({ state: "detached" });
  assert.equal(await page.locator('button[aria-pressed="true"]').innerText(), "j3");
  await check(page, "history-past");
});

test("of thousands of writes, the document has few rows", async (context) => {
  const page = await openHistory(context, { ...counts(20_000), more: true, initial: null, initialNumbers: null, since: null });
  const rows = async () => assert.ok(await page.locator("[role=grid] tr").count() < 60);
  await rows();
  await page.locator("[role=grid]").focus();
  const first = await selected(page).innerText();
  await page.keyboard.press("PageDown");
  await eventually(async () => assert.notEqual(await selected(page).innerText(), first));
  await page.keyboard.press("End");
  await rows();
  await page.click("text=Show earlier writes");
  await expectSent(page, [{ command: "ready" }, { command: "more" }]);
  await check(page, "history-long");
});

test("a value that is not in memory, and a number that is not finite, are gaps", async (context) => {
  const page = await openHistory(context, history("num", NUMBER, [write(1, [5]), write(2, [null], { value: "infinity" }), write(4, [7]), write(6, [], { value: "not in memory" })]));
  await check(page, "history-gaps");
});
