// Scene for an application that does not run: its arm, frames and points.

import { execFile } from "node:child_process";
import { promisify } from "node:util";
import * as vscode from "vscode";
import type { Client } from "../../client";
import { applications } from "../applications";

/** Largest size of a scene, in bytes. */
const LARGEST = 64 << 20;

export class Preview {
  constructor(private readonly client: Client) {}

  /**
   * Returns the scene for a file's application; `undefined` without an application, or if it has faults, which the
   * editor shows.
   */
  async scene(file: vscode.Uri): Promise<object | undefined> {
    // The scene contains shapes to which the folder refers.
    const command = vscode.workspace.isTrusted ? this.client.command : undefined;
    const found = (await applications(this.client)).find(({ folder }) => file.path.startsWith(`${folder.path}/`));
    if (command === undefined || found === undefined) {
      return undefined;
    }
    const scene = promisify(execFile)(command, ["run", found.folder.fsPath, "--scene"], { maxBuffer: LARGEST });
    return scene.then(({ stdout }) => JSON.parse(stdout) as object, () => undefined);
  }
}
