// The page with the sample in a browser: axe-core, operation of a served run, and screenshots in both looks. Arguments:
// the folder of playwright-core, and optionally a folder for screenshots. VAL3_CHROMIUM names another browser.
import assert from "node:assert/strict";
import { mkdirSync, readFileSync, writeFileSync } from "node:fs";
import { createRequire } from "node:module";
import { dirname, join } from "node:path";
import { fileURLToPath, pathToFileURL } from "node:url";
import { exported, HOSTILE, messages } from "./sample.mjs";

const [playwright, pictures] = process.argv.slice(2);
const require = createRequire(import.meta.url);
const { chromium } = require(playwright);
const here = dirname(fileURLToPath(import.meta.url));
const axe = readFileSync(require.resolve("axe-core/axe.min.js"), "utf8");
const dist = join(here, "../dist");
const recording = join(dist, "test/recording.html");
mkdirSync(dirname(recording), { recursive: true });
if (pictures !== undefined) {
  mkdirSync(pictures, { recursive: true });
}
writeFileSync(recording, exported());

const browser = await chromium.launch({
  executablePath: process.env.VAL3_CHROMIUM ?? "/usr/bin/chromium",
  // Only the picture is drawn by an emulated graphics card, which would take longer for the whole page.
  args: ["--no-sandbox", "--disable-gpu", "--enable-unsafe-swiftshader"],
});
let checks = 0;

async function open(address, size, theme, prepare) {
  const page = await browser.newPage({ viewport: size, colorScheme: theme });
  page.on("pageerror", (error) => assert.fail(error));
  page.on("dialog", () => assert.fail("a name was executed"));
  await prepare?.(page);
  await page.goto(address);
  return page;
}

async function check(page, name) {
  await page.evaluate(axe);
  const { violations } = await page.evaluate(() => globalThis.axe.run());
  const found = violations.map(({ id, impact, nodes }) => `${id} (${impact}): ${nodes.map(({ html }) => html.slice(0, 120)).join("; ")}`);
  assert.deepEqual(found, [], name);
  checks += 1;
  if (pictures !== undefined) {
    await page.screenshot({ path: join(pictures, `${name}.png`) });
  }
}

/** Opens the page as in an editor: messages are posted, and its commands are stored and accepted. */
async function asEditor(page) {
  await page.addInitScript(() => {
    globalThis.sent = [];
    globalThis.acquireVsCodeApi = () => ({
      postMessage: (message) => {
        globalThis.sent.push(message);
        if (message.id !== undefined) {
          const conflict = message.command === "save" && !message.overwrite ? { error: "changed", conflict: ["/cell/palletiser.dtx"] } : { error: null, files: ["/cell/palletiser.dtx"] };
          globalThis.postMessage([{ kind: "answer", id: message.id, ...conflict }]);
        }
      },
    });
  });
}

const post = (page, list) => page.evaluate((values) => globalThis.postMessage(values.map((value) => (typeof value === "string" ? Uint8Array.from(atob(value), (character) => character.charCodeAt(0)).buffer : value))),
  list.map((message) => (Buffer.isBuffer(message) ? message.toString("base64") : message)));
const sent = (page) => page.evaluate(() => globalThis.sent.splice(0).filter(({ command }) => command !== "ready" && command !== "reach").map(({ id: _, ...message }) => message));

// Colours do not depend on the size, so the large window has one theme.
for (const [width, height, themes] of [[1280, 800, ["light", "dark"]], [1920, 1080, ["dark"]]]) {
  for (const theme of themes) {
    const page = await open(pathToFileURL(recording).href, { width, height }, theme);
    await page.waitForFunction(() => document.querySelector(".time")?.textContent.includes("of 20.000 s"));
    await page.waitForFunction(() => globalThis.val3View.store.time.value > 0.1);
    // Playing would keep the processors busy during the checks, and move the time between a check and its screenshot.
    await page.click("button:text-is('Pause')");
    await check(page, `folded-${theme}-${width}`);
    for (const [t, carriers] of [[2, ["world", "world"]], [8, ["flange", "world"]], [13, ["frame", null]]]) {
      await page.evaluate((time) => { globalThis.val3View.store.chosen.value = time; }, t);
      const shown = await page.evaluate(() => globalThis.val3View.store.panels.cell.parts.value.map(({ carrier }) => carrier && carrier.kind));
      assert.deepEqual(shown, carriers, `the carton is gripped, carried and released: ${t} s`);
      await page.waitForTimeout(150);
      await check(page, `parts-${t}s-${theme}-${width}`);
    }
    await page.click("header button:text-is('Panels')");
    await page.click("summary:text-is('Keys of the pendant')");
    await page.waitForSelector(".pendant .screen");
    await page.locator("input[type=range]").fill("15.4");
    await page.waitForTimeout(300);
    const shot = (name) => check(page, `${name}-${theme}-${width}`);
    await shot("pendant");
    assert.match(await page.textContent(".blocked"), /This is a recording/);
    assert.equal(await page.getAttribute(".e-stop", "aria-disabled"), "true");
    const { frames, drawCalls } = await page.evaluate(() => globalThis.val3View.stats());
    assert.ok(drawCalls > 5 && drawCalls < 60, `${drawCalls} draw calls`);
    await page.waitForTimeout(300);
    assert.equal(await page.evaluate(() => globalThis.val3View.stats().frames), frames, "an idle page draws nothing");
    for (const tab of ["io", "program", "tasks", "queue", "log", "times", "points"]) {
      await page.click(`#tab-${tab}`);
      await page.waitForTimeout(150);
      await shot(tab);
    }
    assert.ok((await page.textContent(".point-table")).includes(HOSTILE));
    await page.locator("input[type=range]").fill("20");
    await page.click("#tab-tasks");
    await page.click("[role=tab]:text-is('Distances')");
    for (const [kind, text, time] of [["near", "gripper – fence12.1 mm", "15.8"], ["contact", "gripper – pallet", "17.4"]]) {
      const row = page.locator(`.clearances tr.${kind}`);
      assert.ok((await row.textContent()).startsWith(text), await row.textContent());
      await row.locator("[title='Show this time']").click();
      assert.equal(await page.locator("input[type=range]").inputValue(), time);
      await page.waitForSelector(`.name.${kind}:visible`);
      await shot(kind);
      await page.locator("input[type=range]").fill("20");
      await page.waitForTimeout(300);
    }
    await page.close();
  }
}

const live = await open(pathToFileURL(join(dist, "view.html")).href, { width: 1280, height: 800 }, "light", asEditor);
await post(live, messages("debugger").filter(({ kind }) => kind !== "end"));
await live.waitForSelector(".axis");
await live.click("summary:text-is('User page')");
await live.focus("[role=separator]");
await live.keyboard.press("ArrowLeft");
assert.match(await live.getAttribute("main", "style"), /--panel-width: (?:39|40)/, "the border follows the keyboard");
await live.focus(".screen");
await live.keyboard.type("a");
await live.keyboard.press("F3");
await live.keyboard.press("Tab");
assert.equal(await live.evaluate(() => document.activeElement.textContent), "F1", "Tab leaves the page");
assert.deepEqual(await sent(live), [{ command: "operate", keys: { key: 97 } }, { command: "operate", keys: { key: 273 } }]);
await live.click(".e-stop");
await live.click("[aria-label='J1 plus']");
const [stop, jog] = await sent(live);
assert.deepEqual(stop, { command: "operate", keys: { estop: true } });
assert.equal(jog.keys.jog.length, 6);
await live.selectOption(".jog select", "world");
await live.click("[aria-label='Z plus']");
const [straight] = await sent(live);
assert.equal(straight.keys.jog.length, 6);
await live.click("#tab-io");
await live.click("[aria-label='Lock Board-0\\\\%I0']");
assert.deepEqual(await sent(live), [{ command: "operate", keys: { lock: "Board-0\\%I0" } }]);
await live.evaluate(() => { document.querySelector(".signals").scrollTop = 20000; });
await live.waitForFunction(() => document.querySelector(".signals").textContent.includes("Board-14"));
assert.ok(await live.evaluate(() => document.querySelectorAll(".signals tr").length) < 60, "only rows on the screen are drawn");
await live.click("#tab-points");
await live.click(`.point-table button:text-is("pPick[1]")`);
await live.click("text=Teach here");
await post(live, [{ kind: "unsaved", points: [{ name: "pPick", key: "1" }] }]);
await live.click("text=Save to .dtx");
await live.click(".question button:text-is('Overwrite')");
assert.deepEqual(await sent(live), [{ command: "solve", name: "pPick", key: "1" }, { command: "teach", name: "pPick", key: "1" }, { command: "save", overwrite: false }, { command: "save", overwrite: true }]);
await post(live, [{ kind: "unsaved", points: [] }]);
await live.waitForSelector("text=Saved palletiser.dtx");
await check(live, "live-light-1280");
await live.click("[aria-label='Previous error']");
assert.equal(await live.evaluate(() => document.querySelector("input[type=range]").value), "17.4", "the contact");
await live.click("[aria-label='Previous error']");
assert.equal(await live.evaluate(() => document.querySelector("input[type=range]").value), "3.98");
await live.hover(".track");
await live.mouse.wheel(0, -400);
await live.waitForSelector(".whole");
assert.ok(await live.evaluate(() => Number(document.querySelector("input[type=range]").max) < 20), "the wheel zooms");
await live.click(".whole");
await live.locator("input[type=range]").fill("3");
assert.match(await live.textContent(".blocked"), /the past/);
const preview = await open(pathToFileURL(join(dist, "view.html")).href, { width: 900, height: 500 }, "dark", asEditor);
await post(preview, messages("preview").filter(({ kind }) => kind === "scene"));
await preview.click("header button:text-is('Debug')");
assert.deepEqual(await sent(preview), [{ command: "launch", noDebug: false }]);
await check(preview, "preview-dark-900");
await browser.close();
console.log(`test result: ok. ${checks} pages without findings of axe-core; view in the browser`);
