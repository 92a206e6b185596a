// Steps back into and out of programs, for which VS Code has no button.

import * as vscode from "vscode";
import type { DebuggedRun } from "./run";

export function registerStepsBack(run: DebuggedRun): vscode.Disposable[] {
  const step = async (command: "val3/stepBackInto" | "val3/stepBackOut"): Promise<void> => {
    const threadId = vscode.debug.activeStackItem?.threadId;
    if (threadId === undefined) {
      void vscode.window.showInformationMessage("Select a task in the call stack of a stopped run.");
    } else {
      await run.change(command, { threadId });
    }
  };
  return [
    vscode.commands.registerCommand("val3.stepBackInto", () => step("val3/stepBackInto")),
    vscode.commands.registerCommand("val3.stepBackOut", () => step("val3/stepBackOut")),
  ];
}
