// The view "Variables": the parameters and locals of the program in the active editor, as an editable table.

import { readFile } from "node:fs/promises";
import * as vscode from "vscode";
import { LSPErrorCodes, ResponseError } from "vscode-languageclient/node";
import type { Client } from "../client";
import type { CodeFiles } from "../codeView/files";
import { withPolicy } from "../debug/view/page";
import type { EditVariablesParams, VariablesResult } from "../serverRequests";
import { programFile } from "./program";

/** Milliseconds without a change after which the view is updated. */
const PAUSE = 200;

/** Message from the page: it is ready to receive messages, or the user has changed something. */
type FromPage = { command: "ready" } | ({ command: "edit"; id: number } & EditVariablesParams);

export class VariablesView implements vscode.WebviewViewProvider, vscode.Disposable {
  private readonly subscription: vscode.Disposable;
  private view: vscode.WebviewView | undefined;
  private pause: NodeJS.Timeout | undefined;
  /** Whether the page can receive messages. */
  private isReady = false;
  /** Number of the last request. All other responses are ignored. */
  private request = 0;

  constructor(
    private readonly client: Client,
    private readonly views: CodeFiles,
    private readonly page: vscode.Uri,
    private readonly report: (fault: unknown) => void,
  ) {
    this.subscription = vscode.Disposable.from(
      vscode.window.onDidChangeActiveTextEditor(() => this.refreshSoon()),
      client.onDidTellChange(() => this.refreshSoon()),
      client.onDidChangeState(() => this.refreshSoon()),
    );
  }

  dispose(): void {
    clearTimeout(this.pause);
    this.subscription.dispose();
  }

  async resolveWebviewView(view: vscode.WebviewView): Promise<void> {
    this.view = view;
    view.webview.options = { enableScripts: true, localResourceRoots: [] };
    view.webview.onDidReceiveMessage((message: FromPage) => void this.take(message).catch(this.report));
    view.onDidChangeVisibility(() => this.refreshSoon());
    view.onDidDispose(() => {
      this.view = undefined;
      this.isReady = false;
      this.request += 1;
    });
    view.webview.html = withPolicy(await readFile(this.page.fsPath, "utf8"));
  }

  private async take(message: FromPage): Promise<void> {
    if (message.command === "ready") {
      this.isReady = true;
      await this.refresh();
    } else {
      const refused = await this.edit(message);
      this.post({ kind: "answer", id: message.id, refused });
      await this.refresh();
    }
  }

  /** Requests an edit and applies it. Returns the reason why nothing has changed. */
  private async edit({ uri, version, program, edits }: Extract<FromPage, { command: "edit" }>): Promise<string | null> {
    await this.settled(vscode.Uri.parse(uri, true));
    try {
      const params = { uri, version, program, edits };
      const { edit, refused } = await this.client.request("val3/editVariables", params);
      if (edit === null) {
        return refused;
      }
      return (await this.client.applyEdit(edit)) ? null : "The editor could not apply the edit.";
    } catch (fault) {
      const isOld = fault instanceof ResponseError && fault.code === LSPErrorCodes.ContentModified;
      return isOld ? "the program was edited meanwhile" : fault instanceof Error ? fault.message : String(fault);
    }
  }

  /** Waits until the edits in code views are in their file. */
  private async settled(file: vscode.Uri): Promise<void> {
    await Promise.all(this.views.of(file).map((link) => link.settled()));
  }

  private refreshSoon(): void {
    clearTimeout(this.pause);
    this.pause = setTimeout(() => void this.refresh().catch(this.report), PAUSE);
  }

  private async refresh(): Promise<void> {
    const { view } = this;
    if (!this.isReady || view?.visible !== true) {
      return;
    }
    const request = ++this.request;
    const file = programFile(vscode.window.activeTextEditor?.document);
    const variables = file === undefined ? null : await this.variables(file);
    if (request === this.request) {
      view.description = variables?.program ?? "";
      this.post({ kind: "variables", variables, hasProgram: file !== undefined });
    }
  }

  private async variables(file: vscode.Uri): Promise<VariablesResult | null> {
    await this.settled(file);
    // Without a server the view is empty, and the status item shows why.
    return this.client.request("val3/variables", { uri: this.client.addressOf(file) }).catch(() => null);
  }

  private post(message: object): void {
    void this.view?.webview.postMessage(message);
  }
}
