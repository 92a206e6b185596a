// Histories and tables of variables, each in its own tab.

import type { DebugProtocol as Protocol } from "@vscode/debugprotocol";
import * as vscode from "vscode";
import type { DebuggedRun } from "./run";
import { firstValues, HISTORY, TABLE, tabFault, type TabKind, VariablePanel } from "./variablePanel";

/** Argument of a command in the context menu of *Variables*. */
interface VariableContext {
  container?: { variablesReference?: number };
  variable?: Pick<Protocol.Variable, "name">;
}

/** `page` is the file of the page; `report` receives the errors of background work. */
export function registerVariableTabs(run: DebuggedRun, page: vscode.Uri, report: (fault: unknown) => void): vscode.Disposable[] {
  /** Open tabs by kind, session and full name of the variable. */
  const panels = new Map<string, VariablePanel>();
  const show = async (kind: TabKind, name: string, variablesReference: number | undefined): Promise<void> => {
    const values = await firstValues(kind, run, { name, variablesReference: variablesReference ?? null });
    if (values === undefined) {
      return;
    }
    const key = JSON.stringify([kind.noun, run.session?.id, values.name]);
    const open = panels.get(key);
    if (open === undefined) {
      panels.set(key, new VariablePanel(kind, run, page, values, report, () => panels.delete(key)));
    } else {
      open.reveal(values);
    }
  };
  const command = (id: string, kind: TabKind): vscode.Disposable =>
    vscode.commands.registerCommand(id, async ({ container, variable }: VariableContext = {}) => {
      if (variable !== undefined) {
        await show(kind, variable.name, container?.variablesReference).catch((fault: unknown) => void vscode.window.showErrorMessage(tabFault(fault, kind)));
      }
    });
  return [
    command("val3.showHistory", HISTORY),
    command("val3.showTable", TABLE),
    new vscode.Disposable(() => [...panels.values()].forEach((panel) => panel.dispose())),
  ];
}
