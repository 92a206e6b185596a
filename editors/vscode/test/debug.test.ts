// Debugging without an editor: message frames, code views as sources, variables of a line, keys and signals.

import assert from "node:assert/strict";
import { test } from "node:test";
import type { DebugProtocol as Protocol } from "@vscode/debugprotocol";
import * as vscode from "vscode";
import { Mapping } from "../src/codeView/mapping";
import { frame, MessageReader } from "../src/debug/frames";
import { keyArgument, levelFrom } from "../src/debug/robot/input";
import { type Item, merge } from "../src/debug/robot/items";
import { SourceTranslator, type View, type Views } from "../src/debug/sources";
import { markArrays } from "../src/debug/variables";

const FILE = "/cell/pick.pgx";
const CODE = "val3-code:/cell/pick.pgx/pick.pgx%20(code)?file:///cell/pick.pgx";
/** The code begins on line 3 of the file, after the tag. */
const TEXT = "<Programs>\n <Program name=\"pick\">\n  <Code><![CDATA[begin\n  a=1\n  b=2\nend]]></Code>\n </Program>\n</Programs>\n";

function translator(isShown: boolean): SourceTranslator {
  const mapping = Mapping.of(TEXT, 0);
  assert.ok(mapping !== undefined);
  const view: View = { code: CODE, name: "pick.pgx (code)", file: FILE, mapping };
  const views: Views = {
    find: (path) => Promise.resolve(path === CODE ? view : undefined),
    shown: (file) => (isShown && file === FILE ? [view] : []),
  };
  return new SourceTranslator(views);
}

const request = (seq: number, command: string, args: object): Protocol.Request => ({ seq, type: "request", command, arguments: args });
const response = (request_seq: number, command: string, body: unknown): Protocol.Response =>
  ({ seq: 0, type: "response", request_seq, command, success: true, body });

/** Returns the arguments that the adapter receives. */
async function sent(sources: SourceTranslator, asked: Protocol.Request): Promise<Record<string, unknown>> {
  return ((await sources.toAdapter(asked)) as Protocol.Request).arguments as Record<string, unknown>;
}

/** Returns the body that the client receives. */
function shown(sources: SourceTranslator, message: Protocol.ProtocolMessage): unknown {
  return (sources.toClient(message) as Protocol.Response).body;
}

test("messages are found in any pieces of their frames", () => {
  const messages: unknown[] = [];
  const reader = new MessageReader((message) => messages.push(message));
  const bytes = Buffer.concat([frame({ a: "ü" }), frame([1, 2]), frame("x")]);
  for (let at = 0; at < bytes.length; at += 7) {
    reader.push(bytes.subarray(at, at + 7));
  }
  assert.deepEqual(messages, [{ a: "ü" }, [1, 2], "x"]);
  assert.throws(() => reader.push(Buffer.from("Hello\r\n\r\n")), /without its length: Hello/);
});

test("breakpoints of a code view are breakpoints of its file", async () => {
  const sources = translator(false);
  const args = await sent(sources, request(1, "setBreakpoints", { source: { path: CODE }, breakpoints: [{ line: 2, column: 3, condition: "a>0" }] }));
  assert.deepEqual(args.source, { path: FILE, name: "pick.pgx" });
  assert.deepEqual(args.breakpoints, [{ line: 4, column: undefined, endLine: undefined, endColumn: undefined, condition: "a>0" }]);
  const answer = response(1, "setBreakpoints", { breakpoints: [{ id: 7, verified: true, line: 5, source: { path: FILE, name: "pick.pgx" } }] });
  const { breakpoints } = shown(sources, answer) as Protocol.SetBreakpointsResponse["body"];
  assert.deepEqual(breakpoints, [{ id: 7, verified: true, line: 3, source: { path: CODE, name: "pick.pgx (code)" } }]);
  // The adapter finds another location later.
  const moved: Protocol.Event = { seq: 0, type: "event", event: "breakpoint", body: { reason: "changed", breakpoint: { id: 7, verified: true, line: 4, source: { path: FILE } } } };
  const { breakpoint } = shown(sources, moved) as Protocol.BreakpointEvent["body"];
  assert.deepEqual([breakpoint.line, breakpoint.source?.path], [2, CODE]);
});

test("breakpoints of a file and of its code view do not replace each other", async () => {
  const sources = translator(false);
  await sources.toAdapter(request(1, "setBreakpoints", { source: { path: CODE }, breakpoints: [{ line: 2 }] }));
  const args = await sent(sources, request(2, "setBreakpoints", { source: { path: FILE }, breakpoints: [{ line: 5 }] }));
  assert.deepEqual((args.breakpoints as Protocol.SourceBreakpoint[]).map(({ line }) => line), [5, 4]);
  const answer = response(2, "setBreakpoints", { breakpoints: [{ id: 2, verified: true, line: 5 }, { id: 1, verified: true, line: 4 }] });
  assert.deepEqual(shown(sources, answer), { breakpoints: [{ id: 2, verified: true, line: 5 }] });
  const none = await sent(sources, request(3, "setBreakpoints", { source: { path: FILE }, breakpoints: [] }));
  assert.deepEqual((none.breakpoints as Protocol.SourceBreakpoint[]).map(({ line }) => line), [4]);
});

test("a stop is shown in the code view if it is on the screen", () => {
  const frames = (): Protocol.Response => response(9, "stackTrace", { stackFrames: [{ id: 1, name: "pick()", line: 5, column: 1, source: { path: FILE, name: "pick.pgx" } }] });
  const place = (isShown: boolean): unknown[] => {
    const { stackFrames: [found] } = shown(translator(isShown), frames()) as Protocol.StackTraceResponse["body"];
    return [found?.source?.path, found?.line];
  };
  assert.deepEqual(place(true), [CODE, 3]);
  assert.deepEqual(place(false), [FILE, 5]);
});

test("columns of a stop are those of the code view", () => {
  const columns = (line: number, column: number, endColumn: number): unknown[] => {
    const source = { path: FILE, name: "pick.pgx" };
    const frames = response(9, "stackTrace", { stackFrames: [{ id: 1, name: "pick()", line, column, endLine: line, endColumn, source }] });
    const { stackFrames: [found] } = shown(translator(true), frames) as Protocol.StackTraceResponse["body"];
    return [found?.line, found?.column, found?.endLine, found?.endColumn];
  };
  assert.deepEqual(columns(5, 3, 6), [3, 3, undefined, undefined]);
  // The first line of the code follows a tag.
  assert.deepEqual(columns(3, 18, 23), [1, 1, undefined, undefined]);
});

test("lines outside of the code stay lines of the file", () => {
  const output: Protocol.Event = { seq: 0, type: "event", event: "output", body: { output: "x", line: 1, source: { path: FILE } } };
  const { source, line } = shown(translator(true), output) as Protocol.OutputEvent["body"];
  assert.deepEqual([source?.path, line], [FILE, 1]);
});

test("targets and places of breakpoints are those of the code view", async () => {
  const sources = translator(false);
  const args = await sent(sources, request(4, "gotoTargets", { source: { path: CODE }, line: 3 }));
  assert.deepEqual([args.line, (args.source as Protocol.Source).path], [5, FILE]);
  const { targets } = shown(sources, response(4, "gotoTargets", { targets: [{ id: 1, label: "b", line: 5 }] })) as Protocol.GotoTargetsResponse["body"];
  assert.equal(targets[0]?.line, 3);
});

test("keys are typed as characters or pressed by name", () => {
  assert.deepEqual([keyArgument("1"), keyArgument("F1"), keyArgument("a")], [{ key: 49 }, { key: "F1" }, { key: 97 }]);
});

test("levels of signals are read as people write them", () => {
  assert.deepEqual(["true", "0", " TRUE ", "x", "1"].map((text) => levelFrom(text, true)), [true, false, true, undefined, true]);
  assert.deepEqual(["1.5", "-2", "", "x"].map((text) => levelFrom(text, false)), [1.5, -2, undefined, undefined]);
});

test("a tree is drawn again where it has changed, and keeps its other items", () => {
  const item = (label: string, description: string, ...children: Item[]): Item => {
    const shown = new vscode.TreeItem(label);
    shown.description = description;
    return { item: shown, children };
  };
  const tree = (speed: string, level: string, ...further: Item[]): Item =>
    item("root", "", item("arm", speed, item("x", "1")), item("io", "", item("%I0", level), item("%I1", "false"), ...further));
  const shown = tree("0", "false");
  const labels = (changed: Item[]): unknown[] => changed.map(({ item: { label } }) => label);
  const [arm, io] = shown.children;
  assert.deepEqual(labels(merge(shown, tree("0", "false"))), []);
  assert.deepEqual(labels(merge(shown, tree("5", "true"))), ["arm", "%I0"]);
  assert.deepEqual(labels(merge(shown, tree("5", "true", item("%I2", "")))), ["io"]);
  assert.ok(shown.children[0] === arm && shown.children[1] === io);
  assert.equal(JSON.stringify(shown), JSON.stringify(tree("5", "true", item("%I2", ""))));
});

test("the context menu of an array offers a table", () => {
  const variables = [
    { name: "nMany", value: "3 values", variablesReference: 1, indexedVariables: 3 },
    { name: "jHome", value: "{0}", variablesReference: 2, namedVariables: 6 },
  ];
  const menus = (message: Protocol.ProtocolMessage): unknown => {
    const marked = (markArrays(message) as Protocol.VariablesResponse).body.variables;
    return marked.map((variable) => (variable as unknown as Record<string, unknown>)["__vscodeVariableMenuContext"]);
  };
  assert.deepEqual(menus(response(1, "variables", { variables })), ["array", undefined]);
  assert.deepEqual(menus(response(1, "other", { variables })), [undefined, undefined]);
  const failed = { ...response(1, "variables", undefined), success: false };
  assert.equal(markArrays(failed), failed);
});
