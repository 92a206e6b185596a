// Finds the `val3` to run: from the settings, in the extension, or on the PATH.

import { accessSync, constants, statSync } from "node:fs";
import { homedir } from "node:os";
import { basename, delimiter, isAbsolute, join } from "node:path";

const COMMAND = process.platform === "win32" ? "val3.exe" : "val3";

export interface Places {
  /** The user's setting: empty, a path, or a command on the PATH. */
  configured: string;
  /** Extension folder. */
  extension: string;
  /** Environment variable. */
  path: string;
}

/** Returns the path of the server, or a message with the reason and the remedy. */
export function findServer({ configured, extension, path }: Places): { command: string } | { fault: string } {
  const wanted = configured.trim().replace(/^~(?=[/\\])/, homedir());
  if (wanted !== "") {
    const command = (basename(wanted) === wanted ? onPath(path, wanted) : [wanted]).find(isExecutable);
    return command === undefined ? { fault: faultOf(configured, wanted) } : { command };
  }
  const command = [join(extension, "server", COMMAND), ...onPath(path, COMMAND)].find(isExecutable);
  return command === undefined ? { fault: MISSING } : { command };
}

const MISSING = "The command val3 was found neither in the extension nor on the PATH. Install it, or name it in the setting val3.server.path.";

function faultOf(configured: string, wanted: string): string {
  const isCommand = basename(wanted) === wanted;
  const found = statSync(wanted, { throwIfNoEntry: false });
  const [what, remedy] = isCommand
    ? ["no folder of the PATH has such a command", CORRECT]
    : found === undefined
      ? ["there is no such file", CORRECT]
      : found.isDirectory()
        ? ["that is a folder", CORRECT]
        : ["that file may not be executed", "Allow it (chmod +x), or correct the setting."];
  return `The setting val3.server.path names "${configured}", but ${what}. ${remedy}`;
}

const CORRECT = "Correct the setting, or leave it empty for the server that comes with the extension.";

function onPath(path: string, command: string): string[] {
  // A relative folder would be in the workspace.
  const folders = path.split(delimiter).filter((folder) => isAbsolute(folder));
  return folders.map((folder) => join(folder, command));
}

function isExecutable(path: string): boolean {
  try {
    accessSync(path, constants.X_OK);
    return statSync(path).isFile();
  } catch {
    return false;
  }
}
