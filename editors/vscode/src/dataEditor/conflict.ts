// Changes of a file by other programs while it has unsaved changes. When VS Code saves, it detects them only if the
// size of the file differs (`FileService.validateWriteFile`), so a message is shown as soon as the file changes.

import { basename } from "node:path";
import * as vscode from "vscode";

const COMPARE = "Compare";
const RELOAD = "Discard My Changes";

export class Conflicts implements vscode.Disposable {
  private readonly subscriptions: vscode.Disposable[];
  /** Bytes of the file when it was last read or saved here. */
  private known: Promise<Uint8Array | undefined>;

  constructor(private readonly document: vscode.TextDocument, private readonly report: (fault: unknown) => void) {
    this.known = this.stored();
    const { uri } = document;
    const watcher = vscode.workspace.createFileSystemWatcher(new vscode.RelativePattern(vscode.Uri.joinPath(uri, ".."), basename(uri.path)));
    this.subscriptions = [
      watcher,
      watcher.onDidChange(() => void this.changed().catch(report)),
      watcher.onDidCreate(() => void this.changed().catch(report)),
      vscode.workspace.onDidSaveTextDocument((saved) => {
        if (saved === document) {
          this.known = this.stored();
        }
      }),
    ];
  }

  dispose(): void {
    vscode.Disposable.from(...this.subscriptions).dispose();
  }

  private async stored(): Promise<Uint8Array | undefined> {
    try {
      return await vscode.workspace.fs.readFile(this.document.uri);
    } catch {
      // The file was deleted, which VS Code shows in the tab.
      return undefined;
    }
  }

  private async changed(): Promise<void> {
    const [known, now] = await Promise.all([this.known, this.stored()]);
    this.known = Promise.resolve(now);
    const isOther = known !== undefined && now !== undefined && Buffer.compare(known, now) !== 0;
    if (isOther && this.document.isDirty) {
      void this.ask().catch(this.report);
    }
  }

  private async ask(): Promise<void> {
    const name = vscode.workspace.asRelativePath(this.document.uri);
    const message = `Another program has changed ${name}, which has unsaved changes here. Saving replaces that change.`;
    const choice = await vscode.window.showWarningMessage(message, COMPARE, RELOAD);
    if (choice !== undefined) {
      await vscode.window.showTextDocument(this.document, { preview: false });
      await vscode.commands.executeCommand(choice === COMPARE ? "workbench.files.action.compareWithSaved" : "workbench.action.files.revert");
    }
  }
}
