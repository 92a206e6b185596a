// Which `val3` runs: the one of the settings, else the one inside the extension, else the one on the PATH.

import { accessSync, constants, statSync } from "node:fs";
import { homedir } from "node:os";
import { basename, delimiter, join } from "node:path";

const COMMAND = process.platform === "win32" ? "val3.exe" : "val3";

export interface Places {
  /** What the user has set; may be empty, a path, or a command of the PATH. */
  configured: string;
  /** The folder of the extension. */
  extension: string;
  /** The environment variable. */
  path: string;
}

/** The path of the server, or why there is none. */
export function findServer({ configured, extension, path }: Places): { command: string } | { fault: string } {
  const wanted = configured.trim().replace(/^~(?=[/\\])/, homedir());
  if (wanted !== "") {
    const command = (basename(wanted) === wanted ? onPath(path, wanted) : [wanted]).find(isExecutable);
    return command === undefined ? { fault: `The setting val3.server.path names "${configured}", which cannot be run.` } : { command };
  }
  const command = [join(extension, "server", COMMAND), ...onPath(path, COMMAND)].find(isExecutable);
  return command === undefined ? { fault: "The command val3 was found neither in the extension nor on the PATH." } : { command };
}

function onPath(path: string, command: string): string[] {
  const folders = path.split(delimiter).filter((folder) => folder !== "");
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
