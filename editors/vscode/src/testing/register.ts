// Tests in VS Code: the Testing view with its profiles.

import * as vscode from "vscode";
import { State } from "vscode-languageclient/node";
import type { Client } from "../client";
import { registerTestCommands } from "./commands";
import { debug } from "./debugging";
import { Execution } from "./execution";
import { FileCoverage } from "./fileCoverage";
import { TestTree } from "./tree";

export function registerTesting(client: Client, output: vscode.LogOutputChannel): vscode.Disposable[] {
  const tree = new TestTree(client, output);
  const execution = new Execution(client, tree);
  const { Run, Debug, Coverage } = vscode.TestRunProfileKind;
  const run = tree.controller.createRunProfile("Run", Run, (request) => execution.execute(request, false), true);
  const debugged = tree.controller.createRunProfile("Debug", Debug, (request) => debug(request, tree), true);
  const covered = tree.controller.createRunProfile("Run with Coverage", Coverage, (request) => execution.execute(request, true), true);
  covered.loadDetailedCoverage = (_run, file) => Promise.resolve(file instanceof FileCoverage ? file.details() : []);
  return [
    vscode.Disposable.from(tree),
    client.onDidChangeState((state) => state === State.Running && void tree.refresh()),
    ...registerTestCommands(tree, run, debugged),
  ];
}
