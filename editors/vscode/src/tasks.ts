// `val3 check` as a task, with the same output as in CI. The server already lists the findings as problems.

import * as vscode from "vscode";
import type { Client } from "./client";

interface Definition extends vscode.TaskDefinition {
  paths?: string[];
  arguments?: string[];
}

export class CheckTasks implements vscode.TaskProvider {
  constructor(private readonly client: Client) {}

  provideTasks(): vscode.Task[] {
    return (vscode.workspace.workspaceFolders ?? []).flatMap((folder) => this.task({ type: "val3" }, folder, "check") ?? []);
  }

  resolveTask({ definition, scope, name }: vscode.Task): vscode.Task | undefined {
    const folder = typeof scope === "object" ? scope : vscode.TaskScope.Workspace;
    return this.task(definition, folder, name);
  }

  /** Returns `undefined` if the server was not found: Windows would look for a command without a path in the folder first. */
  private task(definition: Definition, scope: vscode.WorkspaceFolder | vscode.TaskScope.Workspace, name: string): vscode.Task | undefined {
    const { command } = this.client;
    if (command === undefined) {
      return undefined;
    }
    const paths = definition.paths ?? ["."];
    const words = ["check", "--format", "concise", ...(definition.arguments ?? []), ...paths];
    const run = new vscode.ProcessExecution(command, words);
    const task = new vscode.Task(definition, scope, name, "val3", run, []);
    task.group = vscode.TaskGroup.Build;
    task.presentationOptions = { reveal: vscode.TaskRevealKind.Always, clear: true };
    return task;
  }
}
