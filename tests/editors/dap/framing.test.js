// Input of the adapter that is no message: the adapter says why, and ends with an exit code that is not 0.
const assert = require("node:assert/strict");
const { spawnSync } = require("node:child_process");
const { after, before, test } = require("node:test");
const { Application } = require("./application");

let app;
before(() => {
  app = new Application("framing", { programs: "\nprogram start()\nbegin\n  while true\n    delay(1)\n  endWhile\nend\n" });
});
after(() => app.remove());

const framed = (message) => {
  const body = JSON.stringify(message);
  return `Content-Length: ${Buffer.byteLength(body)}\r\n\r\n${body}`;
};
const request = (seq, command, args = {}) => framed({ seq, type: "request", command, arguments: args });

/** Returns exit code, standard error output and output events of an adapter with this input. */
function adapter(input) {
  const { status, stderr, stdout } = spawnSync(process.env.VAL3_SERVER, ["dap"], { input, encoding: "utf8", timeout: 60_000 });
  return { status, stderr, stdout };
}

const NUMBER = "error: the session has ended, because the client sent no message: the value of `Content-Length` is not a number: \"abc\"\n";

test("a header without a number ends the adapter with an error", () => {
  const { status, stderr, stdout } = adapter("Content-Length: abc\r\n\r\n");
  assert.deepEqual([status, stderr], [2, NUMBER]);
  assert.match(stdout, /"event":"output".*is not a number/, "the client sees it too");
  assert.match(adapter("Content-Length: 20\r\n\r\n{}").stderr, /the input ends inside a message/);
});

test("so does a header within a session", () => {
  const session = request(1, "initialize", { adapterID: "val3" }) + request(2, "launch", { program: app.folder() }) + request(3, "configurationDone");
  const { status, stderr } = adapter(`${session}Content-Length: abc\r\n\r\n`);
  assert.deepEqual([status, stderr], [2, NUMBER]);
});

test("the end of the input, and messages after which the next one can be read, are no errors of the adapter", () => {
  assert.deepEqual(adapter("").status, 0);
  const { status, stdout } = adapter(`Content-Length: 3\r\n\r\n{a}${request(1, "initialize", { adapterID: "val3" })}`);
  assert.equal(status, 0);
  assert.match(stdout, /the message is not JSON.*"command":"initialize"/s);
});
