// A page in Chromium, for the tests of pages: it is opened as in an editor, checked by axe-core, and stored as a screenshot if
// VAL3_OUTPUT names a folder.
import assert from "node:assert/strict";
import { mkdirSync, readFileSync } from "node:fs";
import { createRequire } from "node:module";
import { join } from "node:path";
import { pathToFileURL } from "node:url";
import { after, before } from "node:test";

const require = createRequire(import.meta.url);
// NODE_PATH, where playwright-core is, applies only to `require`.
const { launch, TIMEOUT } = require("./chromium.js");
const axe = readFileSync(require.resolve("axe-core/axe.min.js"), "utf8");

/** Folder of the bundles. */
export const DIST = join(import.meta.dirname, "../dist");

/** Address of a bundle. */
export const bundle = (name) => pathToFileURL(join(DIST, name)).href;

const pictures = process.env.VAL3_OUTPUT && join(process.env.VAL3_OUTPUT, "view");
let browser;

before(async () => {
  if (pictures) {
    mkdirSync(pictures, { recursive: true });
  }
  browser = await launch();
});
after(() => browser.close());

/**
 * Opens a page for the test `context`, which fails if the page has an error or executes a name, and closes the page.
 * `prepare` is called before the address is opened.
 */
export async function open(context, address, { size = { width: 1280, height: 800 }, theme = "light", permissions = [], prepare } = {}) {
  const own = await browser.newContext({ viewport: size, colorScheme: theme === "light" ? "light" : "dark", permissions });
  const page = await own.newPage();
  page.setDefaultTimeout(TIMEOUT);
  const faults = [];
  page.on("pageerror", (error) => faults.push(error));
  page.on("dialog", (dialog) => {
    faults.push(new Error(`a name was executed: ${dialog.message()}`));
    return dialog.dismiss();
  });
  context.after(async () => {
    await own.close();
    assert.deepEqual(faults, []);
  });
  await prepare?.(page);
  await page.goto(address);
  return page;
}

/** Fails if axe-core finds something on the page, and takes a screenshot. */
export async function check(page, name) {
  // Playwright ends animations and lets the page draw before a screenshot, so axe-core sees final colours.
  await page.screenshot(pictures ? { path: join(pictures, `${name}.png`) } : {});
  await page.evaluate(axe);
  const { violations } = await page.evaluate(() => globalThis.axe.run());
  const found = violations.map(({ id, impact, nodes }) => `${id} (${impact}): ${nodes.map(({ html }) => html.slice(0, 160)).join("; ")}`);
  assert.deepEqual(found, [], name);
}

/** Calls `judge` until it throws nothing, and fails with its error if that takes too long. */
export async function eventually(judge) {
  const end = Date.now() + TIMEOUT;
  for (;;) {
    try {
      return await judge();
    } catch (error) {
      if (!(error instanceof assert.AssertionError) || Date.now() > end) {
        throw error;
      }
    }
    await new Promise((resolve) => setTimeout(resolve, 50));
  }
}

/** Fails if the page does not send the expected messages to its editor, whose fake stores them in `sent`. `select` picks their comparable content. */
export async function expectSent(page, expected, select = (message) => [message]) {
  await eventually(async () => {
    const messages = await page.evaluate(() => globalThis.sent);
    assert.deepEqual(messages.flatMap(select), expected);
  });
  await page.evaluate(() => { globalThis.sent.length = 0; });
}
