// Restricted mode: in a folder that the user does not trust, nothing is executed. The server only reads.

import * as vscode from "vscode";

const MANAGE = "Manage Workspace Trust";

/** Checks that the folder is trusted. Otherwise shows that `what` needs trust: *Running a program*. */
export function checkTrust(what: string): boolean {
  if (!vscode.workspace.isTrusted) {
    void vscode.window.showWarningMessage(`${what} executes code of this folder, which you do not trust.`, MANAGE)
      .then((answer) => answer === MANAGE && vscode.commands.executeCommand("workbench.trust.manage"));
  }
  return vscode.workspace.isTrusted;
}

/** Registers features that execute programs: immediately in a trusted folder, otherwise when the user trusts it. */
export function whenTrusted(register: () => vscode.Disposable[]): vscode.Disposable {
  const registered: vscode.Disposable[] = [];
  const begin = (): void => void registered.push(...register());
  if (vscode.workspace.isTrusted) {
    begin();
  } else {
    registered.push(vscode.workspace.onDidGrantWorkspaceTrust(begin));
  }
  return new vscode.Disposable(() => registered.splice(0).forEach((part) => void part.dispose()));
}
