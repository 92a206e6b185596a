// Time to open an exported run; frames per second, draw calls and memory of the page while it plays, in software rendering.
// Arguments: the folder of playwright-core, the export, and the start time in seconds.
import { createRequire } from "node:module";
import { pathToFileURL } from "node:url";

const [playwright, recording, start = "0"] = process.argv.slice(2);
const { chromium } = createRequire(import.meta.url)(playwright);
const SECONDS = 6;

const browser = await chromium.launch({
  executablePath: process.env.VAL3_CHROMIUM ?? "/usr/bin/chromium-headless-shell",
  args: ["--no-sandbox", "--use-gl=angle", "--use-angle=swiftshader", "--enable-unsafe-swiftshader", "--enable-precise-memory-info"],
});
const page = await browser.newPage({ viewport: { width: 1280, height: 800 } });
page.on("pageerror", (error) => console.log(String(error)));
page.on("console", (message) => console.log(message.text()));
const opened = Date.now();
await page.goto(pathToFileURL(recording).href);
await page.waitForFunction(() => globalThis.val3View?.stats().frames > 0, undefined, { timeout: 120_000 });
console.log(`first picture: ${Date.now() - opened} ms`);
await page.waitForFunction(() => globalThis.val3View.store.end.value !== undefined, undefined, { timeout: 120_000 });
console.log(`entire run: ${Date.now() - opened} ms`);
await page.waitForTimeout(2000);
await page.evaluate((t) => (globalThis.val3View.store.chosen.value = t), Number(start));
const play = page.getByRole("button", { name: "Play", exact: true });
if (await play.isVisible()) {
  await play.click();
}
await page.waitForTimeout(1500);
const stats = () => page.evaluate(() => globalThis.val3View.stats());
const before = await stats();
await page.waitForTimeout(SECONDS * 1000);
const after = await stats();
const memory = await page.evaluate(() => performance.memory.usedJSHeapSize);
console.log(`${((after.frames - before.frames) / SECONDS).toFixed(1)} frames/s, ${after.drawCalls} draw calls, ${(memory / 1e6).toFixed(0)} MB of heap`);
await browser.close();
