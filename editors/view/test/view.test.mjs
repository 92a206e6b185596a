// The page of a run with the sample in a browser: axe-core, operation of a served run, and screenshots in both looks.
import assert from "node:assert/strict";
import { mkdirSync, writeFileSync } from "node:fs";
import { join } from "node:path";
import { test } from "node:test";
import { bundle, check, DIST, eventually, expectSent, open } from "./browser.mjs";
import { exported, HOSTILE, messages } from "./sample.mjs";

mkdirSync(join(DIST, "test"), { recursive: true });
writeFileSync(join(DIST, "test/recording.html"), exported());

/** Time range of the page. */
const RANGE = "input[type=range]";

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

/** Fails if the page does not send these commands. */
const expectCommands = (page, expected) => expectSent(page, expected, ({ id: _, ...message }) => (["ready", "reach"].includes(message.command) ? [] : [message]));

/** Waits until the page draws nothing, which an idle page does. */
const expectIdle = (page) => eventually(async () => {
  const frames = () => page.evaluate(() => globalThis.val3View.stats().frames);
  const before = await frames();
  await page.waitForTimeout(300);
  assert.equal(await frames(), before, "an idle page draws nothing");
});

const expectValue = (page, selector, value) => eventually(async () => assert.equal(await page.inputValue(selector), value));

/** Returns the ids of all tabs in a list. */
const tabs = (page, list) => page.locator(`${list} > [role=tab]`).evaluateAll((all) => all.map(({ id }) => id.replace("tab-", "")));

async function showTab(page, tab) {
  await page.click(`#tab-${tab}`);
  await page.waitForSelector(`#tab-${tab}[aria-selected=true]`);
}

// Colours do not depend on the size, so the large window has one theme.
for (const [width, height, theme] of [[1280, 800, "light"], [1280, 800, "dark"], [1920, 1080, "dark"]]) {
  test(`a recording at ${width}x${height}, ${theme}`, async (context) => {
    const page = await open(context, bundle("test/recording.html"), { size: { width, height }, theme });
    const shot = (name) => check(page, `${name}-${theme}-${width}`);
    await page.waitForFunction(() => document.querySelector(".time")?.textContent.includes("of 20.000 s"));
    await page.waitForFunction(() => globalThis.val3View.store.time.value > 0.1);
    // Playing would keep the processors busy during the checks, and move the time between a check and its screenshot.
    await page.click("button:text-is('Pause')");
    await shot("folded");
    for (const [t, carriers] of [[2, ["world", "world"]], [8, ["flange", "world"]], [13, ["frame", null]]]) {
      await page.evaluate((time) => { globalThis.val3View.store.chosen.value = time; }, t);
      const shown = await page.evaluate(() => globalThis.val3View.store.panels.cell.parts.value.map(({ carrier }) => carrier && carrier.kind));
      assert.deepEqual(shown, carriers, `the carton is gripped, carried and released: ${t} s`);
      await shot(`parts-${t}s`);
    }
    await page.click("header button:text-is('Panels')");
    await page.click("summary:text-is('Keys of the pendant')");
    await page.waitForSelector(".pendant .screen");
    await page.locator(RANGE).fill("15.4");
    await shot("pendant");
    assert.match(await page.textContent(".blocked"), /This is a recording/);
    assert.equal(await page.getAttribute(".e-stop", "aria-disabled"), "true");
    await expectIdle(page);
    const { drawCalls } = await page.evaluate(() => globalThis.val3View.stats());
    assert.ok(drawCalls > 5 && drawCalls < 60, `${drawCalls} draw calls`);
    for (const tab of await tabs(page, ".panel-tabs > .tabs")) {
      await showTab(page, tab);
      await shot(tab);
      for (const inner of await tabs(page, ".panel .tabs")) {
        await showTab(page, inner);
        await shot(inner);
      }
    }
    assert.ok((await page.textContent(".point-table")).includes(HOSTILE));
    await page.locator(RANGE).fill("20");
    await page.click("#tab-tasks");
    await page.click("[role=tab]:text-is('Distances')");
    for (const [kind, text, time] of [["near", "gripper – fence12.1 mm", "15.8"], ["contact", "gripper – pallet", "17.4"]]) {
      const row = page.locator(`.clearances tr.${kind}`);
      await eventually(async () => assert.ok((await row.textContent()).startsWith(text), await row.textContent()));
      await row.locator("[title='Show this time']").click();
      await expectValue(page, RANGE, time);
      await page.waitForSelector(`.name.${kind}:visible`);
      await shot(kind);
      await page.locator(RANGE).fill("20");
    }
  });
}

test("a live run is operated in an editor", async (context) => {
  const live = await open(context, bundle("view.html"), { prepare: asEditor });
  await post(live, messages("debugger").filter(({ kind }) => kind !== "end"));
  await live.waitForSelector(".axis");
  await live.click("summary:text-is('User page')");
  await live.focus("[role=separator]");
  await live.keyboard.press("ArrowLeft");
  await eventually(async () => assert.match(await live.getAttribute("main", "style"), /--panel-width: (?:39|40)/, "the border follows the keyboard"));
  await live.focus(".screen");
  await live.keyboard.type("a");
  await live.keyboard.press("F3");
  await live.keyboard.press("Tab");
  assert.equal(await live.evaluate(() => document.activeElement.textContent), "F1", "Tab leaves the page");
  await expectCommands(live, [{ command: "operate", keys: { key: 97 } }, { command: "operate", keys: { key: 273 } }]);
  await live.click(".e-stop");
  await expectCommands(live, [{ command: "operate", keys: { estop: true } }]);
  const jogged = ({ command, keys }) => (command === "reach" ? [] : [keys.jog?.length]);
  await live.click("[aria-label='J1 plus']");
  await expectSent(live, [6], jogged);
  await live.selectOption(".jog select", "world");
  await live.click("[aria-label='Z plus']");
  await expectSent(live, [6], jogged);
  await live.click("#tab-io");
  await live.click("[aria-label='Lock Board-0\\\\%I0']");
  await expectCommands(live, [{ command: "operate", keys: { lock: "Board-0\\%I0" } }]);
  await live.evaluate(() => { document.querySelector(".signals").scrollTop = 20000; });
  await live.waitForFunction(() => document.querySelector(".signals").textContent.includes("Board-14"));
  assert.ok(await live.evaluate(() => document.querySelectorAll(".signals tr").length) < 60, "only rows on the screen are drawn");
  await live.click("#tab-points");
  await live.click(`.point-table button:text-is("pPick[1]")`);
  await live.click("text=Teach here");
  await post(live, [{ kind: "unsaved", points: [{ name: "pPick", key: "1" }] }]);
  await live.click("text=Save to .dtx");
  await live.click(".question button:text-is('Overwrite')");
  await expectCommands(live, [{ command: "solve", name: "pPick", key: "1" }, { command: "teach", name: "pPick", key: "1" }, { command: "save", overwrite: false }, { command: "save", overwrite: true }]);
  await post(live, [{ kind: "unsaved", points: [] }]);
  await live.waitForSelector("text=Saved palletiser.dtx");
  await check(live, "live-light-1280");
  await live.click("[aria-label='Previous error']");
  await expectValue(live, RANGE, "17.4");
  await live.click("[aria-label='Previous error']");
  await expectValue(live, RANGE, "3.98");
  await live.hover(".track");
  await live.mouse.wheel(0, -400);
  await live.waitForSelector(".whole");
  assert.ok(await live.evaluate((range) => Number(document.querySelector(range).max) < 20, RANGE), "the wheel zooms");
  await live.click(".whole");
  await live.locator(RANGE).fill("3");
  await live.waitForSelector(".blocked:has-text('the past')");
});

test("a scene without a session is previewed in an editor", async (context) => {
  const preview = await open(context, bundle("view.html"), { size: { width: 900, height: 500 }, theme: "dark", prepare: asEditor });
  await post(preview, messages("preview").filter(({ kind }) => kind === "scene"));
  await preview.click("header button:text-is('Debug')");
  await expectCommands(preview, [{ command: "launch", noDebug: false }]);
  await check(preview, "preview-dark-900");
});
