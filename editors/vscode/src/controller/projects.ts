// Projects of the workspace that were pulled from a controller: folders with `.val3/controller.toml`.

import { existsSync } from "node:fs";
import { readFile } from "node:fs/promises";
import { dirname, join } from "node:path";
import * as vscode from "vscode";

/** File in which `val3` stores the address and the state of the last pull or push. */
const STATE = ".val3/controller.toml";

export interface Project {
  /** Absolute path. */
  folder: string;
  address: string;
  /** Serial number of the controller at the last pull or push; empty if it has none. */
  serial: string;
}

/** Returns the projects in the workspace folders and around them, by their folders. `report` receives unreadable ones. */
export async function findProjects(report: (fault: string) => void): Promise<Project[]> {
  const inside = (await vscode.workspace.findFiles(`**/${STATE}`)).map(({ fsPath }) => dirname(dirname(fsPath)));
  const around = localFolders().flatMap((folder) => projectAround(folder) ?? []);
  const folders = [...new Set([...around, ...inside])].sort();
  const read = await Promise.all(folders.map((folder) => readProject(folder).catch((fault: unknown) => report(String(fault)))));
  return read.filter((project) => project !== undefined);
}

/** Returns the paths of the workspace folders on the disk. */
export function localFolders(): string[] {
  const folders = vscode.workspace.workspaceFolders ?? [];
  return folders.filter(({ uri }) => uri.scheme === "file").map(({ uri }) => uri.fsPath);
}

function projectAround(folder: string): string | undefined {
  const parent = dirname(folder);
  return existsSync(join(folder, STATE)) ? folder : parent === folder ? undefined : projectAround(parent);
}

/** Reads the state of a project. Throws if the file cannot be read or has another form. */
export async function readProject(folder: string): Promise<Project> {
  const path = join(folder, STATE);
  const { parse } = await import("smol-toml");
  const state = parse(await readFile(path, "utf8")) as { address?: unknown; controller?: { serial?: unknown } };
  const { address, controller: { serial } = {} } = state;
  if (typeof address !== "string" || typeof serial !== "string") {
    throw new Error(`${path} contains no address or serial number. Remove it, and pull again.`);
  }
  return { folder, address, serial };
}
