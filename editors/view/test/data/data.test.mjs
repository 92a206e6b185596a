// The tables in a browser: keyboard, clipboard, checks during typing, axe-core, and screenshots in two looks.
import assert from "node:assert/strict";
import { test } from "node:test";
import { check, eventually, expectSent, open } from "../browser.mjs";
import { fakeEditor, HOSTILE, PAGE, tables } from "./sample.mjs";

async function openTables(context, content, theme) {
  const prepare = (page) => page.addInitScript(fakeEditor, content);
  const page = await open(context, PAGE, { theme, prepare, permissions: ["clipboard-read", "clipboard-write"] });
  await page.waitForSelector("[role=treegrid]");
  return page;
}

/** Fails if the page does not send these edits. Trials during typing do not count. */
const expectEdits = (page, expected) => expectSent(page, expected, ({ command, check: isTrial, edits }) => (command === "edit" && isTrial !== true ? edits : []));

const active = (page) => page.evaluate(() => document.querySelector("td.active")?.textContent);
const expectActive = (page, text) => eventually(async () => assert.equal((await active(page)).trim(), text));
const expectCopied = (page, text) => eventually(async () => assert.equal(await page.evaluate(() => navigator.clipboard.readText()), text));
const keys = async (page, ...names) => {
  for (const name of names) {
    await page.keyboard.press(name);
  }
};

/** Returns the edit that sets cells, each as datum, column and text. */
const setting = (...cells) => ({ kind: "set", cells: cells.map(([name, column, text]) => ({ place: { name, key: "0" }, column, text })) });

for (const theme of ["light", "dark"]) {
  test(`tables of all types, ${theme}`, async (context) => {
    const page = await openTables(context, tables({ points: 60 }), theme);
    await page.locator("[role=treegrid]").focus();
    await check(page, `points-${theme}`);
    for (const type of ["num", "frame", "bool", "string", "Slot", ""]) {
      await page.click(`[id="type-${type}"]`);
      await page.locator("[role=treegrid]").focus();
      await keys(page, "Space", ...(type === "Slot" ? ["ArrowDown", "Space", "ArrowUp"] : []));
      await check(page, `${type || "all"}-${theme}`);
    }
    await keys(page, "Insert");
    await page.waitForSelector("dialog[open]");
    await check(page, `add-${theme}`);
    await keys(page, "Escape");
    await page.waitForSelector("dialog", { state: "detached" });
  });
}

test("cells are edited with the keyboard", async (context) => {
  const page = await openTables(context, tables());
  await keys(page, "Tab", "Tab", "Tab");
  await page.locator("[role=treegrid]").focus();
  await expectActive(page, "pPoint0");
  await keys(page, "ArrowRight", "ArrowRight", "ArrowRight", "ArrowRight", "ArrowDown");
  await expectActive(page, "1.5");
  await page.keyboard.type("12");
  await keys(page, "Escape");
  await expectActive(page, "1.5");
  await page.keyboard.type("12,x");
  await page.waitForSelector(".cell-editor[aria-invalid=true]");
  assert.equal(await page.textContent("#cell-verdict"), "`12,x` is not a number.");
  await keys(page, "Enter");
  await page.waitForFunction(() => /not a number/.test(document.querySelector(".notice").textContent));
  await keys(page, "Control+A");
  await page.keyboard.type("12.25");
  await keys(page, "Enter");
  await page.waitForFunction(() => document.activeElement.getAttribute("role") === "treegrid");
  await expectEdits(page, [setting(["pPoint1", "x", "12,x"]), setting(["pPoint1", "x", "12.25"])]);
  // Enter moves down.
  await expectActive(page, "3");
  await keys(page, "ArrowUp", "F2");
  await page.keyboard.type("1");
  await keys(page, "Tab");
  await page.waitForFunction(() => document.querySelector("td.active").dataset.column === "5");
  // F2 selects the text.
  await expectEdits(page, [setting(["pPoint1", "x", "1"])]);
  // Access.
  await keys(page, "Home", "ArrowRight", "Enter");
  await eventually(async () => assert.ok(await page.evaluate(() => globalThis.sent.some(({ edits, check: isTrial }) => isTrial === false && edits[0].kind === "access"))));
});

test("a rectangle is copied and pasted elsewhere, and only changed cells are written", async (context) => {
  const page = await openTables(context, tables());
  await page.locator("[role=treegrid]").focus();
  await keys(page, "Home", "Control+Home", "ArrowRight", "ArrowRight", "ArrowRight", "ArrowRight", "Shift+ArrowDown", "Shift+ArrowRight", "Control+C");
  await expectCopied(page, "0\t0\n1.5\t37");
  await keys(page, "ArrowDown", "ArrowDown", "ArrowLeft", "Control+V");
  await expectEdits(page, [setting(["pPoint3", "x", "0"], ["pPoint3", "y", "0"], ["pPoint4", "x", "1.5"], ["pPoint4", "y", "37"])]);
  await keys(page, "Control+C");
  await expectCopied(page, "0");
  await keys(page, "Control+V", "Delete");
  // Delete sets the default; pasting the same text changes nothing.
  await eventually(async () => assert.deepEqual(await page.evaluate(() => globalThis.sent.flatMap(({ edits }) => edits?.flatMap(({ cells }) => cells.map(({ text }) => text)) ?? [])), [null]));
});

test("data are found, deleted with a view of their uses, and created", async (context) => {
  const page = await openTables(context, tables());
  await page.locator("[role=treegrid]").focus();
  await keys(page, "Control+F");
  await page.keyboard.type("box");
  await page.waitForFunction(() => document.querySelector("[id='type-num'] .count").textContent === "1 of 2");
  await keys(page, "Control+A", "Delete");
  await page.click("[id='type-num']");
  await page.locator("[role=treegrid]").focus();
  await keys(page, "Space");
  await page.waitForSelector("td:has-text('[2,1]')");
  assert.equal(await page.getAttribute("tr:has(td:has-text('nTimes'))", "aria-expanded"), "true");
  await keys(page, "Control+Home", "Delete");
  await page.waitForSelector(".uses li");
  assert.match(await page.textContent("dialog"), /1 place uses it/);
  await check(page, "delete-light");
  await page.click("dialog .primary");
  await page.waitForSelector("td:has-text('nTimes')", { state: "detached" });
  await page.waitForFunction(() => document.activeElement.getAttribute("role") === "treegrid");
  await page.click("[id='type-string']");
  await eventually(async () => assert.ok((await page.textContent(".grid")).includes(HOSTILE)));
  // A new datum is shown and selected.
  await page.locator("[role=treegrid]").focus();
  await keys(page, "Insert");
  await page.waitForSelector("dialog[open]");
  await page.keyboard.type("sNew");
  await keys(page, "Enter");
  await page.waitForFunction(() => document.querySelector("td.active")?.textContent.includes("sNew"));
});

test("a file that cannot be edited shows the reason", async (context) => {
  const page = await openTables(context, tables());
  await page.evaluate((content) => globalThis.postMessage({ kind: "tables", tables: content }), { ...tables(), problem: "Line 7 has a syntax error." });
  await page.waitForSelector(".problem");
  await page.locator("[role=treegrid]").focus();
  await keys(page, "Control+Home", "Delete");
  await page.waitForFunction(() => document.querySelector(".notice")?.textContent.includes("Line 7"));
  await check(page, "problem-light");
});
