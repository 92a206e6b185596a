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
  const run = tree.controller.createRunProfile("Run", Run, (request, token) => execution.execute(request, token, false), true);
  const debugged = tree.controller.createRunProfile("Debug", Debug, (request, token) => debug(request, token, tree), true);
  const covered = tree.controller.createRunProfile(
    "Run with Coverage", Coverage, (request, token) => execution.execute(request, token, true), true,
  );
  covered.loadDetailedCoverage = (_run, file) => Promise.resolve(file instanceof FileCoverage ? file.details() : []);
  return [
    vscode.Disposable.from(tree),
    client.onDidChangeState((state) => state === State.Running && void tree.refresh()),
    ...registerTestCommands(tree, run, debugged),
  ];
}
