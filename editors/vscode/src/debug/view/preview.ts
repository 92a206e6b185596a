// Scene for an application that does not run: its arm, frames and points.

import { execFile } from "node:child_process";
import { promisify } from "node:util";
import * as vscode from "vscode";
import type { Client } from "../../client";
import { type Application, applications } from "../applications";
import type { Message } from "./wire";

/** Largest size of a scene, in bytes. */
const LARGEST = 64 << 20;

/** Application with its scene. */
export interface Shown {
  application: Application;
  scene: Message;
}

export class Preview {
  constructor(private readonly client: Client) {}

  /**
   * Returns the scene of a file's application, or of the only application; `undefined` without an application, or if it
   * has faults, which the editor shows.
   */
  async of(file: vscode.Uri | undefined): Promise<Shown | undefined> {
    // The scene contains shapes to which the folder refers.
    const command = vscode.workspace.isTrusted ? this.client.command : undefined;
    const all = await applications(this.client);
    const own = all.find(({ folder }) => file?.path.startsWith(`${folder.path}/`));
    const application = own ?? (all.length === 1 ? all[0] : undefined);
    if (command === undefined || application === undefined) {
      return undefined;
    }
    const scene = promisify(execFile)(command, ["run", application.folder.fsPath, "--scene"], { maxBuffer: LARGEST });
    return scene.then(({ stdout }) => ({ application, scene: JSON.parse(stdout) as Message }), () => undefined);
  }
}
