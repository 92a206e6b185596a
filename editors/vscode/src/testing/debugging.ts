// Tests under the debugger, in one session each.

import * as vscode from "vscode";
import { TYPE } from "../debug/configurations";
import { chosenTests, finish } from "./execution";
import { isScenario, type Result } from "./results";
import type { Test, TestTree } from "./tree";

/** Event with which the debug adapter reports the result of a test. */
const RESULT = "val3/testResult";
/** Configuration key by which a test's session is recognised. */
const KEY = "testItem";

export async function debug(request: vscode.TestRunRequest, tree: TestTree): Promise<void> {
  const run = tree.controller.createTestRun(request);
  try {
    const chosen = chosenTests(request, tree);
    chosen.forEach(({ item }) => run.enqueued(item));
    for (const test of chosen) {
      if (run.token.isCancellationRequested) {
        run.skipped(test.item);
      } else {
        await debugTest(run, test);
      }
    }
  } finally {
    run.end();
  }
}

/** Debugs a test until its session has ended. */
async function debugTest(run: vscode.TestRun, test: Test): Promise<void> {
  const { item, folder } = test;
  const workspace = item.uri && vscode.workspace.getWorkspaceFolder(item.uri);
  const isOwn = ({ configuration }: vscode.DebugSession): boolean => configuration[KEY] === item.id;
  let result: Result | undefined;
  let end: () => void = () => undefined;
  const ended = new Promise<void>((resolve) => (end = resolve));
  const subscriptions = [
    vscode.debug.onDidReceiveDebugSessionCustomEvent(({ session, event, body }) => {
      result = event === RESULT && isOwn(session) ? (body as Result) : result;
    }),
    vscode.debug.onDidStartDebugSession((session) => {
      if (isOwn(session)) {
        run.token.onCancellationRequested(() => void vscode.debug.stopDebugging(session));
      }
    }),
    vscode.debug.onDidTerminateDebugSession((session) => isOwn(session) && end()),
  ];
  try {
    run.started(item);
    if (await vscode.debug.startDebugging(workspace, { ...configuration(test), [KEY]: item.id }, { testRun: run })) {
      await ended;
    }
  } finally {
    vscode.Disposable.from(...subscriptions).dispose();
  }
  if (result === undefined) {
    run.skipped(item);
  } else {
    finish(run, item, result, workspace?.uri.fsPath ?? folder);
  }
}

/** Returns the configuration: for a test program its test, for a scenario its script with the application. */
function configuration({ name, folder, item }: Test): vscode.DebugConfiguration {
  const launch = { type: TYPE, request: "launch", name, program: folder };
  const file = item.uri?.fsPath ?? "";
  return isScenario(file) ? { ...launch, script: file } : { ...launch, test: name };
}
