// Calls the tools of `val3 mcp` with the command line of the MCP inspector.

const assert = require("node:assert/strict");
const { execFileSync } = require("node:child_process");
const { join } = require("node:path");

const INSPECTOR = join(process.env.NODE_PATH, ".bin/mcp-inspector");
const EXAMPLES = join(process.env.VAL3_ROOT, "examples");

/** Returns the response to a method, called in the examples with `options` of the server. */
function call(options, method, ...words) {
  const server = [process.env.VAL3_SERVER, "mcp", "--root", EXAMPLES, ...options];
  const text = execFileSync(INSPECTOR, ["--cli", ...server, "--method", method, ...words], { encoding: "utf8" });
  return JSON.parse(text);
}

const named = (tool, ...words) => ["--tool-name", tool, ...words.flatMap((word) => ["--tool-arg", word])];

const checks = {
  "tools are listed": () => {
    assert.deepEqual([call([], "tools/list").tools.length, call(["--write"], "tools/list").tools.length], [6, 9]);
  },
  "a check has its counts as data": () => {
    const answer = call([], "tools/call", ...named("check", "path=faulty/usr/usrapp/sorter", "max=2"));
    assert.equal(answer.isError, false);
    assert.deepEqual(answer.structuredContent, { ok: false, errors: 9, warnings: 2, infos: 1 });
  },
  "a wrong path is an error with a remedy": () => {
    // The inspector also prints a response with an error, and then exits with an error.
    const refused = (fault) => /is outside of .*--root/.test(fault.stdout);
    assert.throws(() => call([], "tools/call", ...named("check", "path=../..")), refused);
  },
  "prompts and resources are listed": () => {
    assert.equal(call([], "prompts/list").prompts.length, 3);
    assert.equal(call([], "resources/list").resources[0].uri, "val3://guide");
  },
};

let failed = 0;
for (const [name, check] of Object.entries(checks)) {
  try {
    check();
  } catch (fault) {
    failed += 1;
    console.log(`FAIL ${name}: ${fault}`);
  }
}
console.log(`${Object.keys(checks).length - failed} passed, ${failed} failed`);
process.exitCode = failed ? 1 : 0;
