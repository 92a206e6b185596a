// The process of a debug session, which may not exist or may end at any time.

import assert from "node:assert/strict";
import { mkdtempSync, rmSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { after, test } from "node:test";
import type { DebugProtocol as Protocol } from "@vscode/debugprotocol";
import { Adapter } from "../src/debug/adapter";
import { SourceTranslator } from "../src/debug/sources";

const folder = mkdtempSync(join(tmpdir(), "val3-adapter-"));
after(() => rmSync(folder, { recursive: true }));

type Message = Protocol.ProtocolMessage & { command?: string; event?: string; success?: boolean; message?: string };

const request = (seq: number, command: string): Protocol.Request => ({ seq, type: "request", command });

/** Runs a session with this command to its end, and returns its messages. A request is sent immediately. */
async function session(command: string): Promise<Message[]> {
  const adapter = new Adapter(command, undefined, new SourceTranslator({ find: () => Promise.resolve(undefined), shown: () => [] }));
  const messages: Message[] = [];
  const ended = new Promise<void>((resolve) => {
    adapter.onDidSendMessage((message) => {
      messages.push(message as Message);
      if ((message as Message).event === "terminated") {
        resolve();
      }
    });
  });
  adapter.handleMessage(request(1, "initialize"));
  await ended;
  adapter.handleMessage(request(2, "disconnect"));
  adapter.dispose();
  return messages;
}

function script(name: string, ...lines: string[]): string {
  const path = join(folder, name);
  writeFileSync(path, ["#!/bin/sh", ...lines, ""].join("\n"), { mode: 0o755 });
  return path;
}

/** Returns the failed requests, with the reasons. */
const refusals = (messages: Message[]): string[] =>
  messages.filter(({ success }) => success === false).map(({ command, message }) => `${command}: ${message}`);

test("a process that cannot be started refuses the requests and ends the session", async () => {
  const missing = join(folder, "missing");
  const [first = "", ...others] = refusals(await session(missing));
  assert.match(first, /^initialize: .*missing cannot be started/);
  assert.deepEqual(others, ["disconnect: The debugger has ended."]);
});

test("a process that dies ends the session, and its last words are shown", async () => {
  const command = script("dies", "read line", "echo broken >&2", "exit 3");
  const messages = await session(command);
  assert.equal(refusals(messages)[0], `initialize: ${command} dap has ended with 3.`);
  const outputs = messages.filter(({ event }) => event === "output") as Protocol.OutputEvent[];
  assert.deepEqual(outputs.map(({ body }) => body.output), ["broken\n"]);
});

test("output that is no message ends the session with a reason", async () => {
  const command = script("garbage", "printf 'Hello\\r\\n\\r\\n'", "read line");
  const [reason = ""] = refusals(await session(command));
  assert.match(reason, /a message without its length: Hello/);
});

test("a request that was answered is not refused at the end", async () => {
  const answer = JSON.stringify({ seq: 1, type: "response", request_seq: 1, command: "initialize", success: true });
  const command = script("answers", `printf 'Content-Length: ${answer.length}\\r\\n\\r\\n%s' '${answer}'`);
  const messages = await session(command);
  assert.deepEqual(messages.map(({ type, success, event }) => [type, success, event]), [
    ["response", true, undefined], ["event", undefined, "terminated"], ["response", false, undefined],
  ]);
});
