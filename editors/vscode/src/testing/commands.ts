// *Run test | Debug test* above test programs: the commands of the server's code lenses.

import { dirname } from "node:path";
import * as vscode from "vscode";
import type { TestTree } from "./tree";

export const RUN_TEST = "val3.runTest";
export const DEBUG_TEST = "val3.debugTest";

export function registerTestCommands(tree: TestTree, run: vscode.TestRunProfile, debug: vscode.TestRunProfile): vscode.Disposable[] {
  const start = (profile: vscode.TestRunProfile) => (project: string, program: string) => startTest(tree, profile, project, program);
  return [vscode.commands.registerCommand(RUN_TEST, start(run)), vscode.commands.registerCommand(DEBUG_TEST, start(debug))];
}

/** Executes a test of the application with this `.pjx`. */
async function startTest(tree: TestTree, profile: vscode.TestRunProfile, project: string, program: string): Promise<void> {
  await vscode.workspace.saveAll(false);
  await tree.refresh();
  const tests = tree.find(dirname(vscode.Uri.parse(project).fsPath), program);
  if (tests.length === 0) {
    void vscode.window.showErrorMessage(`The test ${program} cannot be executed: \`val3 test --list\` does not list it. `
      + "The Testing view shows the reason at its application.");
    return;
  }
  const request = new vscode.TestRunRequest(tests.map(({ item }) => item), undefined, profile);
  // The run has a separate token.
  await profile.runHandler(request, new vscode.CancellationTokenSource().token);
}
