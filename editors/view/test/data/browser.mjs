// The tables in a browser: keyboard, clipboard, checks during typing, axe-core, and screenshots in three looks.
// Arguments: the folder of playwright-core, and optionally a folder for screenshots. VAL3_CHROMIUM names another
// browser.
import assert from "node:assert/strict";
import { mkdirSync, readFileSync } from "node:fs";
import { createRequire } from "node:module";
import { join } from "node:path";
import { fakeEditor, HOSTILE, PAGE, tables } from "./sample.mjs";

const [playwright, pictures] = process.argv.slice(2);
const require = createRequire(import.meta.url);
const { chromium } = require(playwright);
const axe = readFileSync(require.resolve("axe-core/axe.min.js"), "utf8");
if (pictures !== undefined) {
  mkdirSync(pictures, { recursive: true });
}

const browser = await chromium.launch({ executablePath: process.env.VAL3_CHROMIUM ?? "/usr/bin/chromium", args: ["--no-sandbox"] });
let checks = 0;

async function open(content, theme = "light", size = { width: 1280, height: 800 }) {
  const context = await browser.newContext({ viewport: size, colorScheme: theme, permissions: ["clipboard-read", "clipboard-write"] });
  const page = await context.newPage();
  page.on("pageerror", (error) => assert.fail(error));
  page.on("dialog", () => assert.fail("a name was executed"));
  await page.addInitScript(fakeEditor, content);
  await page.goto(PAGE);
  await page.waitForSelector("[role=treegrid]");
  return page;
}

async function check(page, name) {
  await page.waitForTimeout(250);
  if (pictures !== undefined) {
    await page.screenshot({ path: join(pictures, `${name}.png`) });
  }
  await page.evaluate(axe);
  const { violations } = await page.evaluate(() => globalThis.axe.run());
  const found = violations.map(({ id, impact, nodes }) => `${id} (${impact}): ${nodes.map(({ html }) => html.slice(0, 160)).join("; ")}`);
  assert.deepEqual(found, [], name);
  checks += 1;
}

const sent = (page, kind) => page.evaluate((kind) => globalThis.sent.splice(0).filter(({ command, check }) => command === kind && check !== true).map(({ id: _, check: __, command: ___, ...rest }) => rest), kind);
const active = (page) => page.evaluate(() => document.querySelector("td.active")?.textContent);
const keys = async (page, ...names) => {
  for (const name of names) {
    await page.keyboard.press(name);
  }
};

for (const theme of ["light", "dark"]) {
  const page = await open(tables({ points: 60 }), theme);
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
  await page.close();
}

const page = await open(tables());
// Arrow keys, a value typed over another one, and Escape.
await keys(page, "Tab", "Tab", "Tab");
await page.locator("[role=treegrid]").focus();
assert.equal((await active(page)).trim(), "pPoint0");
await keys(page, "ArrowRight", "ArrowRight", "ArrowRight", "ArrowRight", "ArrowDown");
assert.equal(await active(page), "1.5");
await page.keyboard.type("12");
await keys(page, "Escape");
assert.equal(await active(page), "1.5");
await page.keyboard.type("12,x");
await page.waitForSelector(".cell-editor[aria-invalid=true]");
assert.equal(await page.textContent("#cell-verdict"), "`12,x` is not a number.");
await keys(page, "Enter");
await page.waitForFunction(() => /not a number/.test(document.querySelector(".notice").textContent));
await keys(page, "Control+A");
await page.keyboard.type("12.25");
await keys(page, "Enter");
await page.waitForFunction(() => document.activeElement.getAttribute("role") === "treegrid");
assert.deepEqual((await sent(page, "edit")).at(-1), { edits: [{ kind: "set", cells: [{ place: { name: "pPoint1", key: "0" }, column: "x", text: "12.25" }] }] });
assert.equal(await active(page), "3", "Enter moves down");
await keys(page, "ArrowUp", "F2");
await page.keyboard.type("1");
await keys(page, "Tab");
await page.waitForFunction(() => document.querySelector("td.active").dataset.column === "5");
assert.deepEqual((await sent(page, "edit")).at(-1).edits[0].cells[0].text, "1", "F2 selects the text");
// A rectangle is copied and pasted elsewhere; only changed cells are written.
await keys(page, "Home", "Control+Home", "ArrowRight", "ArrowRight", "ArrowRight", "ArrowRight", "Shift+ArrowDown", "Shift+ArrowRight", "Control+C");
assert.equal(await page.evaluate(() => navigator.clipboard.readText()), "0\t0\n1\t37");
await keys(page, "ArrowDown", "ArrowDown", "ArrowLeft", "Control+V");
await page.waitForFunction(() => globalThis.sent.some(({ check }) => check === false));
assert.deepEqual((await sent(page, "edit"))[0].edits, [{ kind: "set", cells: [["pPoint3", "x", "0"], ["pPoint3", "y", "0"], ["pPoint4", "x", "1"], ["pPoint4", "y", "37"]].map(([name, column, text]) => ({ place: { name, key: "0" }, column, text })) }]);
await keys(page, "Control+C", "Control+V");
await keys(page, "Delete");
await page.waitForFunction(() => globalThis.sent.some(({ check }) => check === false));
assert.deepEqual((await sent(page, "edit")).map(({ edits }) => edits[0].cells.map(({ text }) => text)), [[null]], "Delete sets the default; pasting the same text changes nothing");
// Access, search, expansion, deletion.
await keys(page, "Home", "ArrowRight", "Enter");
await page.waitForFunction(() => globalThis.sent.some(({ check }) => check === false));
assert.equal((await sent(page, "edit"))[0].edits[0].kind, "access");
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
assert.ok(await page.evaluate(() => document.activeElement.getAttribute("role") === "treegrid"));
await page.click("[id='type-string']");
assert.ok((await page.textContent(".grid")).includes(HOSTILE));
// A new datum is shown and selected.
await page.locator("[role=treegrid]").focus();
await keys(page, "Insert");
await page.keyboard.type("sNew");
await keys(page, "Enter");
await page.waitForFunction(() => document.querySelector("td.active")?.textContent.includes("sNew"));
// A file that cannot be edited shows the reason.
await page.evaluate((tables) => globalThis.postMessage({ kind: "tables", tables }), { ...tables(), problem: "Line 7 has a syntax error." });
await page.waitForSelector(".problem");
await page.locator("[role=treegrid]").focus();
await keys(page, "Control+Home", "Delete");
assert.match(await page.textContent(".notice"), /Line 7/);
await check(page, "problem-light");
await browser.close();
console.log(`test result: ok. ${checks} pages without findings of axe-core; tables in the browser`);
