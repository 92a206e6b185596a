// The page shows that its server is silent or has ended, and continues when the server is back.
const assert = require("node:assert/strict");
const { test } = require("node:test");
const { moveForever, now, served, until } = require("./served.js");

test("a stopped server is noticed after 3 s, and its run goes on", () => served([], async (run) => {
  const page = await run.open();
  await until(page, 0.5);
  const answer = page.getByText("No answer from the server for 3 s.");
  assert.equal(await answer.count(), 0);
  const start = Date.now();
  run.process.kill("SIGSTOP");
  try {
    await answer.first().waitFor();
    assert.ok(Date.now() - start > 1900, "a server is not silent between two clock messages");
  } finally {
    run.process.kill("SIGCONT");
  }
  await answer.first().waitFor({ state: "detached" });
  await until(page, await now(page) + 1);
}));

test("open pages continue after a restart of the server with the same secret", () => served(["--power"], async (run) => {
  const pages = [await run.open(0), await run.open(1)];
  await Promise.all(pages.map((page) => until(page, 2)));
  const addresses = run.pages;
  await pages[0].getByRole("tab", { name: "Tasks" }).click();
  await run.end();
  for (const page of pages) {
    await page.getByRole("status", { name: "Status" }).getByText(/^The connection to the run is lost\.$|^The run and its server have ended\.$/).waitFor();
    await page.waitForFunction(() => document.title === "palletiser – no connection");
  }
  assert.deepEqual(await run.restart(), addresses);
  for (const page of pages) {
    await page.waitForFunction(() => window.val3View.store.lost.value === undefined && window.val3View.store.end.value === undefined);
    await until(page, 1);
  }
  const [operator, guest] = pages;
  await operator.getByRole("tab", { name: "Tasks", selected: true }).first().waitFor();
  await operator.getByRole("tab", { name: "Pendant" }).click();
  await operator.getByRole("button", { name: "Hold", exact: true }).click();
  await guest.getByRole("status", { name: "Status" }).getByText(/^The arm is held/).waitFor();
  assert.equal(await guest.evaluate(() => window.val3View.store.scene.value.role), "guest");
}, moveForever, "a secret of the test"));
