// The event log: levels of messages, faults with their remedy and number, and the way from a message to its line and time.
const assert = require("node:assert/strict");
const { readFileSync, writeFileSync } = require("node:fs");
const { join } = require("node:path");
const { test } = require("node:test");
const { served, setProgram } = require("./served.js");

/** Converts the application to s8, whose messages have levels, and lets it log three of them before it fails. */
function logAndFail(folder) {
  const file = join(folder, "usr/usrapp/palletiser/palletiser.pjx");
  writeFileSync(file, readFileSync(file, "latin1").replace("s7.11.3", "s8.10"), "latin1");
  setProgram(folder, `
  logMsg("three boxes",1)
  logMsg("few boxes",2)
  logMsg("no boxes",3)
  delay(0.2)
  putln(toString("",1/0))`);
}

test("messages have levels, and a fault has its number, its remedy and its line", () => served([], async (run) => {
  const page = await run.open();
  await page.getByRole("tab", { name: /^Tasks\s*1/ }).click();
  await page.getByRole("tab", { name: "Event log" }).click();
  const log = page.getByRole("table", { name: "Event log" });
  const row = (text) => log.getByRole("row").filter({ hasText: text });
  await row("division by zero").waitFor();
  const classes = await Promise.all(["three boxes", "few boxes", "no boxes", "division by zero"].map((text) => row(text).getAttribute("class")));
  assert.deepEqual(classes, ["messages log info", "messages log warning", "errors log error", "errors"]);
  const colour = (text) => row(text).locator("td").last().evaluate((cell) => getComputedStyle(cell).color);
  assert.equal(new Set([await colour("three boxes"), await colour("few boxes"), await colour("no boxes")]).size, 3);

  // The row of the error opens its complete text, its remedy and its line.
  await row("division by zero").locator("td").last().click();
  const whole = page.getByRole("region", { name: "Event", exact: true });
  await whole.getByText('putln(toString("",1/0))', { exact: true }).waitFor();
  const remedy = await page.getByRole("alert", { name: "Fault" }).locator("p").last().innerText();
  await whole.getByText(remedy, { exact: true }).waitFor();
  const time = await whole.getByTitle("Show this time").innerText();
  await whole.getByTitle("Show this time").click();
  await page.waitForFunction((time) => window.val3View.store.chosen.value?.toFixed(3) === time, time.replace(" s", ""));
  await page.getByRole("button", { name: "Return to the present" }).click();
  await whole.getByRole("button", { name: /^start:\d+$/ }).click();
  await page.getByRole("tab", { name: "Program", selected: true }).waitFor();
  await page.locator(".code-table tr.opened").getByText('putln(toString("",1/0))').waitFor();

  // Kinds and words filter the rows.
  await page.getByRole("tab", { name: /^Tasks\s*1/ }).click();
  await page.getByRole("checkbox", { name: "Messages" }).uncheck();
  await row("few boxes").waitFor({ state: "detached" });
  assert.equal(await row("no boxes").count(), 1, "an error of the log is an error");
  await page.getByRole("searchbox", { name: "Filter events" }).fill("boxes");
  await row("division by zero").waitFor({ state: "detached" });
  assert.equal(await log.locator("tbody tr:not(.spacer)").count(), 1);
}, logAndFail));
