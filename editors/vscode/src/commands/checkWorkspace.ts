// "Check Workspace": runs `val3 check` in each folder and shows its output.

import * as vscode from "vscode";
import type { Walkthrough } from "../walkthrough";

export function registerCheckWorkspace(walkthrough: Walkthrough): vscode.Disposable[] {
  return [vscode.commands.registerCommand("val3.checkWorkspace", () => checkWorkspace(walkthrough))];
}

async function checkWorkspace(walkthrough: Walkthrough): Promise<void> {
  const tasks = (await vscode.tasks.fetchTasks({ type: "val3" })).filter((task) => task.name === "check");
  if (tasks.length === 0) {
    void vscode.window.showInformationMessage("There is nothing to check: no folder is open, or the server val3 was not found.");
    return;
  }
  await Promise.all(tasks.map((task) => vscode.tasks.executeTask(task)));
  walkthrough.done("check");
}
