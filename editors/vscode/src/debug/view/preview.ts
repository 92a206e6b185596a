// Scene for an application that does not run: its arm, frames and points.

import { execFile } from "node:child_process";
import { promisify } from "node:util";
import * as vscode from "vscode";
import type { Client } from "../../client";
import { type Application, applications } from "../applications";
import type { Message } from "./wire";

/** Largest size of a scene, in bytes. */
const LARGEST = 64 << 20;

type SceneMessage = Extract<Message, { kind: "scene" }>;

/** Application with its scene. */
export interface Shown {
  application: Application;
  scene: SceneMessage;
}

export class Preview {
  constructor(private readonly client: Client) {}

  /**
   * Returns the scene of a file's application, of the only application, or of the application in `[run.default]` of a
   * workspace folder; `undefined` without an application, or if it has faults, which the editor shows.
   */
  async of(file: vscode.Uri | undefined): Promise<Shown | undefined> {
    // The scene contains shapes to which the folder refers.
    const command = vscode.workspace.isTrusted ? this.client.command : undefined;
    if (command === undefined) {
      return undefined;
    }
    const all = await applications(this.client);
    const own = all.find(({ folder }) => file?.path.startsWith(`${folder.path}/`));
    const application = own ?? (all.length === 1 ? all[0] : undefined);
    if (application !== undefined) {
      const scene = await sceneOf(command, application.folder);
      return scene && { application, scene };
    }
    for (const { uri } of all.length === 0 ? [] : (vscode.workspace.workspaceFolders ?? [])) {
      const scene = await sceneOf(command, uri);
      const named = scene && all.find(({ name, folder }) => name === scene.application && folder.path.startsWith(uri.path));
      if (scene !== undefined && named !== undefined) {
        return { application: named, scene };
      }
    }
    return undefined;
  }
}

/** Returns the scene of an application, or of the application that the settings of a folder name. */
function sceneOf(command: string, folder: vscode.Uri): Promise<SceneMessage | undefined> {
  const scene = promisify(execFile)(command, ["run", folder.fsPath, "--scene"], { maxBuffer: LARGEST });
  return scene.then(({ stdout }) => JSON.parse(stdout) as SceneMessage, () => undefined);
}
