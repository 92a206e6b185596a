// Which `val3` runs: the one of the settings, else the one inside the extension, else the one on the PATH.

import { accessSync, constants, statSync } from "node:fs";
import { delimiter, join } from "node:path";
import * as vscode from "vscode";

const COMMAND = process.platform === "win32" ? "val3.exe" : "val3";

/** The path of the server. Tells the user what to do, and gives nothing, when there is none. */
export async function findServer(context: vscode.ExtensionContext): Promise<string | undefined> {
  const configured = vscode.workspace.getConfiguration("val3").get<string>("server.path", "").trim();
  if (configured !== "") {
    return isExecutable(configured) ? configured : offerSettings(`The setting val3.server.path names "${configured}", which cannot be run.`);
  }
  const candidates = [context.asAbsolutePath(join("server", COMMAND)), ...onPath()];
  return candidates.find(isExecutable) ?? offerSettings(
    "The command val3 was found neither in the extension nor on the PATH. Install it, or name it in the setting val3.server.path.",
  );
}

function onPath(): string[] {
  const folders = (process.env.PATH ?? "").split(delimiter).filter((folder) => folder !== "");
  return folders.map((folder) => join(folder, COMMAND));
}

function isExecutable(path: string): boolean {
  try {
    accessSync(path, constants.X_OK);
    return statSync(path).isFile();
  } catch {
    return false;
  }
}

async function offerSettings(message: string): Promise<undefined> {
  const settings = "Open Settings";
  void vscode.window.showErrorMessage(message, settings).then((chosen) => {
    if (chosen === settings) {
      void vscode.commands.executeCommand("workbench.action.openSettings", "val3.server.path");
    }
  });
  return undefined;
}
