// Times between frames while tables with 10,000 rows scroll, in software rendering. Arguments: the folder of
// playwright-core, and optionally the number of rows.
import { createRequire } from "node:module";
import { fakeEditor, PAGE, tables } from "./sample.mjs";

const [playwright, rows = "10000"] = process.argv.slice(2);
const { chromium } = createRequire(import.meta.url)(playwright);
const SECONDS = 5;

const browser = await chromium.launch({ executablePath: process.env.VAL3_CHROMIUM ?? "/usr/bin/chromium-headless-shell", args: ["--no-sandbox", "--enable-precise-memory-info"] });
const page = await browser.newPage({ viewport: { width: 1280, height: 800 } });
page.on("pageerror", (error) => console.log(String(error)));
await page.addInitScript(fakeEditor, tables({ points: Number(rows), elements: Number(rows) }));
const devtools = await page.context().newCDPSession(page);
await devtools.send("Performance.enable", { timeDomain: "threadTicks" });
const opened = Date.now();
await page.goto(PAGE);
await page.waitForSelector("tbody tr:nth-child(20)");
console.log(`first picture: ${Date.now() - opened} ms`);

/** Scrolls by this number of pixels per frame. Returns the times between frames in ms, sorted. */
const scroll = (pixels) => page.evaluate(([pixels, seconds]) => new Promise((resolve) => {
  const [box, times, start] = [document.querySelector(".grid"), [], performance.now()];
  let before = start;
  const frame = (now) => {
    times.push(now - before);
    before = now;
    box.scrollTop += pixels;
    if (now - start < seconds * 1000) {
      requestAnimationFrame(frame);
    } else {
      resolve(times.slice(1).sort((left, right) => left - right));
    }
  };
  requestAnimationFrame(frame);
}), [pixels, SECONDS]);

/** Returns the seconds of work by the page so far, independent of other load on the machine. */
async function work() {
  const { metrics } = await devtools.send("Performance.getMetrics");
  const named = metrics.filter(({ name }) => ["ScriptDuration", "LayoutDuration", "RecalcStyleDuration", "TaskDuration"].includes(name));
  return Object.fromEntries(named.map(({ name, value }) => [name, value]));
}

async function measure(name, pixels) {
  await page.evaluate(() => { document.querySelector(".grid").scrollTop = 0; });
  await page.waitForTimeout(500);
  const before = await work();
  const times = await scroll(pixels);
  const after = await work();
  const at = (part) => times[Math.floor(part * (times.length - 1))].toFixed(1);
  console.log(`${name}, ${pixels} pixels a frame: ${(times.length / SECONDS).toFixed(1)} frames/s; median ${at(0.5)} ms, 95 % ${at(0.95)} ms, longest ${at(1)} ms`);
  const per = Object.keys(after).map((name) => `${name.replace("Duration", "")} ${(((after[name] - before[name]) * 1000) / times.length).toFixed(1)} ms`);
  console.log(`  work a frame: ${per.join(", ")}`);
}

await measure("points", 24);
await measure("points", 600);
await page.locator("[role=treegrid]").focus();
await page.keyboard.press("Control+End");
await page.keyboard.press("Home");
await page.keyboard.press("Space");
await page.waitForFunction((rows) => document.querySelector("[role=treegrid]").getAttribute("aria-rowcount") > rows, 2 * Number(rows));
await measure("points and elements of an array", 600);
const typed = await page.evaluate(async () => {
  const search = document.getElementById("data-search");
  const start = performance.now();
  search.value = "ppoint99";
  search.dispatchEvent(new Event("input", { bubbles: true }));
  await new Promise((resolve) => requestAnimationFrame(() => setTimeout(resolve)));
  return performance.now() - start;
});
console.log(`search: ${typed.toFixed(0)} ms`);
console.log(`${((await page.evaluate(() => performance.memory.usedJSHeapSize)) / 1e6).toFixed(0)} MB of heap`);
await browser.close();
