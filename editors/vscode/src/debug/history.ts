// Histories of variables, each in its own tab.

import type { DebugProtocol as Protocol } from "@vscode/debugprotocol";
import * as vscode from "vscode";
import { COUNT, historyFault, HistoryPanel } from "./historyPanel";
import type { DebuggedRun } from "./run";

/** Argument of a command in the context menu of *Variables*. */
interface VariableContext {
  container?: { variablesReference?: number };
  variable?: Pick<Protocol.Variable, "name">;
}

/** `page` is the file of the page; `report` receives the errors of background work. */
export function registerHistory(run: DebuggedRun, page: vscode.Uri, report: (fault: unknown) => void): vscode.Disposable[] {
  /** Open tabs by the session and the full name of the variable. */
  const panels = new Map<string, HistoryPanel>();
  const show = async (name: string, variablesReference: number | undefined): Promise<void> => {
    const history = await run.request("val3/history", { name, variablesReference: variablesReference ?? null, count: COUNT });
    if (history === undefined) {
      return;
    }
    const key = JSON.stringify([run.session?.id, history.name]);
    const open = panels.get(key);
    if (open === undefined) {
      panels.set(key, new HistoryPanel(run, page, history, report, () => panels.delete(key)));
    } else {
      open.reveal(history);
    }
  };
  return [
    vscode.commands.registerCommand("val3.showHistory", async ({ container, variable }: VariableContext = {}) => {
      if (variable !== undefined) {
        await show(variable.name, container?.variablesReference).catch((fault: unknown) => void vscode.window.showErrorMessage(historyFault(fault)));
      }
    }),
    new vscode.Disposable(() => [...panels.values()].forEach((panel) => panel.dispose())),
  ];
}
