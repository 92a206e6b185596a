// The view *Variables*: its filter, and the kinds of its variables.

import type { DebugProtocol as Protocol } from "@vscode/debugprotocol";
import * as vscode from "vscode";
import type { DebuggedRun } from "./run";

/** Property of a variable from which VS Code sets the context key `debugProtocolVariableMenuContext`. */
const MENU = "__vscodeVariableMenuContext";

export function registerVariableFilter(run: DebuggedRun): vscode.Disposable {
  return vscode.commands.registerCommand("val3.filterVariables", async () => {
    try {
      const present = await run.request("val3/variableFilter", {});
      const filter = present === undefined ? undefined : await vscode.window.showInputBox({
        title: "Filter Variables",
        value: present.filter,
        prompt: "Names of global variables to show, for example traj, nPush* or io:di*. Empty shows all.",
      });
      if (filter !== undefined) {
        await run.request("val3/variableFilter", { filter });
      }
    } catch (fault) {
      void vscode.window.showErrorMessage(fault instanceof Error ? fault.message : String(fault));
    }
  });
}

/** Marks arrays and collections in a response, so that their context menu offers a table. */
export function markArrays(message: Protocol.ProtocolMessage): Protocol.ProtocolMessage {
  const { command, body, success } = message as Protocol.VariablesResponse;
  if (message.type === "response" && command === "variables" && success) {
    const marked = body.variables.map((variable) => (variable.indexedVariables === undefined ? variable : { ...variable, [MENU]: "array" }));
    return { ...message, body: { ...body, variables: marked } } as Protocol.VariablesResponse;
  }
  return message;
}
