// Steps back into and out of programs, and the end of a call of the debug console, for which VS Code has no button.

import * as vscode from "vscode";
import type { DebuggedRun } from "./run";

export function registerTaskCommands(run: DebuggedRun): vscode.Disposable[] {
  const change = async (command: "val3/stepBackInto" | "val3/stepBackOut" | "val3/endCall"): Promise<void> => {
    const threadId = vscode.debug.activeStackItem?.threadId;
    if (threadId === undefined) {
      void vscode.window.showInformationMessage("Select a task in the call stack of a stopped run.");
    } else {
      await run.change(command, { threadId });
    }
  };
  return [
    vscode.commands.registerCommand("val3.stepBackInto", () => change("val3/stepBackInto")),
    vscode.commands.registerCommand("val3.stepBackOut", () => change("val3/stepBackOut")),
    vscode.commands.registerCommand("val3.endCall", () => change("val3/endCall")),
  ];
}
