// The robot next to the code: the page of `val3 run --serve` with messages from the debug session. Without a session it
// shows the points and frames of the application at the cursor.

import { readFile } from "node:fs/promises";
import * as vscode from "vscode";
import type { DebuggedRun, Source } from "../run";
import { checkTrust } from "../../trust";
import { withPolicy } from "./page";
import type { Preview } from "./preview";

const TYPE = "val3.robotView";

/** Message from the page: it is ready, shows a line, or sends a request to the controller. */
type FromPage = { command: "ready" } | { command: "reveal"; source: Source } | { command: string; id: number };

export class RobotView implements vscode.Disposable {
  private readonly subscription: vscode.Disposable;
  private panel: vscode.WebviewPanel | undefined;
  /** Whether the page can receive messages. */
  private isReady = false;

  constructor(
    private readonly run: DebuggedRun,
    private readonly preview: Preview,
    private readonly page: vscode.Uri,
    private readonly report: (fault: unknown) => void,
  ) {
    this.subscription = vscode.Disposable.from(
      run.onDidView((messages) => this.post(...messages)),
      run.onDidChangeSession(() => void this.begin().catch(report)),
      vscode.window.onDidChangeTextEditorSelection(({ textEditor, selections }) => this.follow(textEditor, selections[0])),
      vscode.window.onDidChangeActiveTextEditor(() => void this.showPreview().catch(report)),
      vscode.workspace.onDidSaveTextDocument(() => void this.showPreview().catch(report)),
    );
  }

  dispose(): void {
    vscode.Disposable.from(this.subscription, ...(this.panel === undefined ? [] : [this.panel])).dispose();
  }

  /** Shows the view next to the code. */
  async show(): Promise<void> {
    if (!checkTrust("The view of the robot")) {
      return;
    }
    if (this.panel !== undefined) {
      this.panel.reveal(undefined, true);
      return;
    }
    const options = { enableScripts: true, retainContextWhenHidden: true, localResourceRoots: [] };
    const place = { viewColumn: vscode.ViewColumn.Beside, preserveFocus: true };
    const panel = vscode.window.createWebviewPanel(TYPE, "Robot", place, options);
    this.panel = panel;
    panel.onDidDispose(() => {
      this.panel = undefined;
      this.isReady = false;
      void this.run.showView(false).catch(this.report);
    });
    panel.webview.onDidReceiveMessage((message: FromPage) => void this.take(message).catch(this.report));
    panel.webview.html = withPolicy(await readFile(this.page.fsPath, "utf8"));
  }

  private async take(message: FromPage): Promise<void> {
    if (message.command === "ready") {
      this.isReady = true;
      await this.begin();
    } else if (message.command === "reveal") {
      await vscode.commands.executeCommand("val3.openLine", (message as { source: Source }).source);
    } else {
      const answer = await this.run.request("val3/view", message).catch((fault: unknown) => ({
        error: fault instanceof Error ? fault.message : String(fault),
      }));
      const reply: Record<string, unknown> = answer ?? { error: "No application is being debugged." };
      this.post({ kind: "answer", id: (message as { id: number }).id, error: null, ...reply });
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

  private async showPreview(): Promise<void> {
    const { activeTextEditor: editor } = vscode.window;
    if (this.isReady && this.run.session === undefined && editor !== undefined) {
      const scene = await this.preview.scene(editor.document.uri);
      if (scene !== undefined) {
        this.post(scene);
        this.follow(editor, editor.selection);
      }
    }
  }

  /** Highlights the point at the cursor. */
  private follow({ document }: vscode.TextEditor, selection: vscode.Selection | undefined): void {
    if (this.isReady && selection !== undefined && document.languageId.startsWith("val3")) {
      const word = document.getWordRangeAtPosition(selection.active);
      this.post({ kind: "select", name: word === undefined ? null : document.getText(word) });
    }
  }

  private post(...messages: object[]): void {
    if (this.isReady) {
      void this.panel?.webview.postMessage(messages.map(withBytes));
    }
  }
}

/** Converts a message for the page: samples are sent as bytes. */
function withBytes(message: object): object {
  return "base64" in message && typeof message.base64 === "string" ? new Uint8Array(Buffer.from(message.base64, "base64")) : message;
}
