// The robot next to the code: the page of `val3 run --serve` with messages from the debug session. Without a session it
// shows the points and frames of the application in the active editor.

import { readFile } from "node:fs/promises";
import * as vscode from "vscode";
import type { DebuggedRun, Source } from "../run";
import { checkTrust } from "../../trust";
import { withPolicy } from "./page";
import type { Application } from "../applications";
import { startApplication } from "../lenses";
import type { Preview } from "./preview";
import type { Message } from "./wire";

const TYPE = "val3.robotView";

/** Key of the workspace's memory: whether the view was open when it was last used. */
const IS_OPEN = "robotView.isOpen";

/** Message from the page: it is ready, shows a line, starts the application, or sends a request to the controller. */
type FromPage = { command: "ready" } | { command: "reveal"; source: Source } | { command: "launch"; noDebug: boolean } | { command: string; id: number };

export class RobotView implements vscode.Disposable {
  private readonly subscription: vscode.Disposable;
  private panel: vscode.WebviewPanel | undefined;
  /** Whether the page can receive messages. */
  private isReady = false;
  /** File of the last active editor, or the project file that was chosen in the view VAL 3. */
  private file: vscode.Uri | undefined;
  /** Application of the preview. */
  private application: Application | undefined;
  /** Number of requested previews. Only the last one is shown. */
  private previews = 0;

  constructor(
    private readonly run: DebuggedRun,
    private readonly preview: Preview,
    private readonly page: vscode.Uri,
    private readonly memory: vscode.Memento,
    private readonly report: (fault: unknown) => void,
  ) {
    this.subscription = vscode.Disposable.from(
      run.onDidView((messages) => this.post(...messages)),
      run.onDidChangeSession(() => void this.changeSession().catch(report)),
      vscode.window.onDidChangeTextEditorSelection(({ textEditor, selections }) => this.follow(textEditor, selections[0])),
      vscode.window.tabGroups.onDidChangeTabs(() => void this.followFile().catch(report)),
      vscode.window.tabGroups.onDidChangeTabGroups(() => void this.followFile().catch(report)),
      vscode.workspace.onDidSaveTextDocument(() => void this.showPreview().catch(report)),
    );
  }

  dispose(): void {
    vscode.Disposable.from(this.subscription, ...(this.panel === undefined ? [] : [this.panel])).dispose();
  }

  /** Shows the view next to the code, with the application of a project file if one is given. */
  async show(project?: vscode.Uri): Promise<void> {
    if (!checkTrust("The view of the robot")) {
      return;
    }
    this.file = project ?? activeFile() ?? this.file;
    if (this.panel !== undefined) {
      this.panel.reveal(undefined, true);
      await this.showPreview();
      return;
    }
    const isAlone = vscode.window.tabGroups.all.every(({ tabs }) => tabs.length === 0);
    const options = { enableScripts: true, retainContextWhenHidden: true, localResourceRoots: [] };
    const place = { viewColumn: vscode.ViewColumn.Beside, preserveFocus: true };
    const panel = vscode.window.createWebviewPanel(TYPE, "Robot", place, options);
    this.panel = panel;
    panel.onDidDispose(() => {
      this.panel = undefined;
      this.isReady = false;
      void this.memory.update(IS_OPEN, false);
      void this.run.showView(false).catch(this.report);
    });
    panel.webview.onDidReceiveMessage((message: FromPage) => void this.take(message).catch(this.report));
    panel.webview.html = withPolicy(await readFile(this.page.fsPath, "utf8"));
    if (isAlone) {
      // Editors, such as the one that shows the first stopped line, open next to the view.
      await vscode.commands.executeCommand("workbench.action.lockEditorGroup");
    }
    await this.memory.update(IS_OPEN, true);
  }

  private async take(message: FromPage): Promise<void> {
    if (message.command === "ready") {
      this.isReady = true;
      await this.begin();
    } else if (message.command === "reveal") {
      await vscode.commands.executeCommand("val3.openLine", (message as { source: Source }).source);
    } else if (message.command === "launch") {
      if (this.application !== undefined) {
        await startApplication(this.application, undefined, (message as { noDebug: boolean }).noDebug);
      }
    } else {
      const answer = await this.run.request("val3/view", message).catch((fault: unknown) => ({
        error: fault instanceof Error ? fault.message : String(fault),
      }));
      const { error = null, ...more }: { error?: string | null; [key: string]: unknown } = answer ?? { error: "No application is being debugged." };
      this.post({ kind: "answer", id: (message as { id: number }).id, error, ...more });
    }
  }

  /** Shows the active session, beginning with its present state, or the application in the editor. */
  private async begin(): Promise<void> {
    if (!this.isReady) {
      return;
    } else if (this.run.session === undefined) {
      await this.showPreview();
    } else {
      await this.run.showView(true);
    }
  }

  /** Shows the new session. The view opens with it, unless the user has closed the view. A unit test rarely needs it. */
  private async changeSession(): Promise<void> {
    const { session } = this.run;
    if (session !== undefined && this.panel === undefined) {
      const isWanted = this.memory.get<boolean>(IS_OPEN) ?? session.configuration["test"] === undefined;
      await (isWanted ? this.show() : undefined);
    }
    await this.begin();
  }

  /** Shows the application of the active editor after a change of the editor. */
  private async followFile(): Promise<void> {
    const file = activeFile();
    if (file !== undefined && file.toString() !== this.file?.toString()) {
      this.file = file;
      await this.showPreview();
    }
  }

  /** Shows the application of the file, if no application is being debugged. */
  private async showPreview(): Promise<void> {
    this.previews += 1;
    const number = this.previews;
    const isCurrent = (): boolean => this.isReady && this.run.session === undefined && number === this.previews;
    const shown = isCurrent() ? await this.preview.of(this.file) : undefined;
    // Meanwhile a session may have begun, or the editor may have changed.
    if (shown !== undefined && isCurrent()) {
      this.application = shown.application;
      this.post(shown.scene);
      const { activeTextEditor: editor } = vscode.window;
      if (editor !== undefined) {
        this.follow(editor, editor.selection);
      }
    }
  }

  /** Highlights a datum of the tables. */
  select(name: string | undefined): void {
    this.post({ kind: "select", name: name ?? null });
  }

  /** Highlights the point at the cursor. */
  private follow({ document }: vscode.TextEditor, selection: vscode.Selection | undefined): void {
    if (this.isReady && selection !== undefined && document.languageId.startsWith("val3")) {
      const word = document.getWordRangeAtPosition(selection.active);
      this.post({ kind: "select", name: word === undefined ? null : document.getText(word) });
    }
  }

  private post(...messages: readonly Message[]): void {
    if (this.isReady) {
      void this.panel?.webview.postMessage(messages.map(withBytes));
    }
  }
}

/** Returns the file of the active tab, which shows text or tables. */
function activeFile(): vscode.Uri | undefined {
  const input = vscode.window.tabGroups.activeTabGroup.activeTab?.input;
  return input instanceof vscode.TabInputText || input instanceof vscode.TabInputCustom ? input.uri : undefined;
}

/** Converts a message for the page: samples are sent as bytes. */
function withBytes(message: Message): object {
  return message.kind === "samples" ? new Uint8Array(Buffer.from(message.base64, "base64")) : message;
}
