// The page shows that its server is silent, and continues when the server responds again.
const assert = require("node:assert/strict");
const { test } = require("node:test");
const { now, served, until } = require("./served.js");

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
