// List of a variable's recorded writes. Selecting a write opens its line.

import type { DebugProtocol as Protocol } from "@vscode/debugprotocol";
import * as vscode from "vscode";
import { type HistoryRow, historyRows } from "./historyRows";
import type { HistoryArguments } from "./requests";
import type { DebuggedRun } from "./run";

/** Number of writes in the first list, and factor for the size of each longer list. */
const [COUNT, GROWTH] = [100, 10];

/** Argument of a command in the context menu of *Variables*. */
interface VariableContext {
  container?: { variablesReference?: number };
  variable?: Pick<Protocol.Variable, "name">;
}

export function registerHistory(run: DebuggedRun): vscode.Disposable {
  return vscode.commands.registerCommand("val3.showHistory", async ({ container, variable }: VariableContext = {}) => {
    if (variable !== undefined) {
      await show(run, { name: variable.name, variablesReference: container?.variablesReference });
    }
  });
}

async function show(run: DebuggedRun, data: HistoryArguments, count = COUNT): Promise<void> {
  try {
    const history = await run.request("val3/history", { ...data, count });
    if (history === undefined) {
      return;
    }
    const title = `History of ${history.name}`;
    const row = await vscode.window.showQuickPick<HistoryRow & vscode.QuickPickItem>(historyRows(history), {
      title,
      placeHolder: "Select a write to open its line",
      matchOnDescription: true,
    });
    if (row?.isMore === true) {
      await show(run, data, count * GROWTH);
    } else if (row?.source !== undefined) {
      await vscode.commands.executeCommand("val3.openLine", row.source);
    }
  } catch (fault) {
    const reason = fault instanceof Error ? fault.message : String(fault);
    void vscode.window.showErrorMessage(reason === "notStopped" ? "The history is available while the run is stopped." : reason);
  }
}
