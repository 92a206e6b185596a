// "Show Changes": a file of the controller next to the local file, in VS Code's own comparison.

import { existsSync } from "node:fs";
import { join } from "node:path";
import * as vscode from "vscode";
import { decodeFile } from "../encoding/documents";
import { type ControllerNode, isLocal, isOnController } from "./items";
import type { ControllerDocuments } from "./documents";
import type { Transfers } from "./transfers";

export const SHOW_CHANGES = "val3.controller.showChanges";

/** Opens the comparison of a file. A side without the file is empty. */
export async function showChanges({ project, file }: ControllerNode, transfers: Transfers, documents: ControllerDocuments): Promise<void> {
  if (file === undefined) {
    return;
  }
  const { path } = file;
  let text = "";
  if (isOnController(file)) {
    const finished = await transfers.run({
      ...project,
      title: `Reading ${path} from the controller`,
      subcommand: "pull",
      words: ["--print", path],
      keepsEdits: true,
    });
    if (finished?.code !== 0) {
      await (finished && transfers.showFailure(finished));
      return;
    }
    if (isBinary(finished.output)) {
      void vscode.window.showInformationMessage(`${path} is not a text file, so its changes cannot be shown.`);
      return;
    }
    text = await decodeFile(finished.output);
  }
  const local = join(project.folder, path);
  const right = isLocal(file) && existsSync(local) ? vscode.Uri.file(local) : documents.add(project, path, "absent", "");
  const name = path.slice(path.lastIndexOf("/") + 1);
  await vscode.commands.executeCommand("vscode.diff", documents.add(project, path, "controller", text), right, `${name} (controller ↔ local)`);
}

/** Opens the local file. */
export async function openLocalFile({ project, file }: ControllerNode): Promise<void> {
  await (file && vscode.commands.executeCommand("vscode.open", vscode.Uri.file(join(project.folder, file.path))));
}

/** Whether the bytes have a NUL and no byte order mark of UTF-16. */
function isBinary(bytes: Buffer): boolean {
  const mark = bytes.subarray(0, 2).toString("hex");
  return mark !== "fffe" && mark !== "feff" && bytes.includes(0);
}
