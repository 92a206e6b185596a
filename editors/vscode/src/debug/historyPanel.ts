// Tab with the history of a variable: its recorded writes as a list and a plot.

import { readFile } from "node:fs/promises";
import * as vscode from "vscode";
import type { HistoryBody, WriteLine } from "./requests";
import type { DebuggedRun } from "./run";
import { withPolicy } from "./view/page";

const TYPE = "val3.history";

/** Number of requested writes at first, and factor for each request of more writes. */
export const [COUNT, GROWTH] = [1000, 10];

/** Milliseconds after a stop until the history is searched, so that the search does not delay quick steps. */
const PAUSE = 200;

/** Message from the page. */
type FromPage = { command: "ready" } | { command: "openLine"; source: WriteLine; isFinal: boolean } | { command: "earlier" };

type ToPage = { kind: "history"; history: HistoryBody } | { kind: "note"; note: string | null };

export class HistoryPanel implements vscode.Disposable {
  private readonly panel: vscode.WebviewPanel;
  /** Debug session to which the history belongs. */
  private readonly session: vscode.DebugSession | undefined;
  private readonly subscription: vscode.Disposable;
  private isReady = false;
  /** Number of writes of the next request. */
  private count = COUNT;
  /** Number of the last request. Responses to earlier ones are ignored. */
  private request = 0;
  private note: string | null = null;
  private pause: NodeJS.Timeout | undefined;
  /** Whether the run has stopped elsewhere while the tab was hidden. A hidden history is not searched. */
  private isStale = false;

  constructor(
    private readonly run: DebuggedRun,
    private readonly page: vscode.Uri,
    private history: HistoryBody,
    private readonly report: (fault: unknown) => void,
    onDispose: () => void,
  ) {
    this.session = run.session;
    const options = { enableScripts: true, retainContextWhenHidden: true, localResourceRoots: [] };
    this.panel = vscode.window.createWebviewPanel(TYPE, `History of ${history.name}`, vscode.ViewColumn.Beside, options);
    this.subscription = vscode.Disposable.from(
      run.onDidStop(() => this.refreshSoon()),
      run.onDidResume(() => this.resume()),
      this.panel.onDidChangeViewState(() => this.isStale && this.refreshSoon()),
      run.onDidChangeSession(() => this.changeSession()),
      this.panel.webview.onDidReceiveMessage((message: FromPage) => void this.take(message).catch(report)),
    );
    this.panel.onDidDispose(() => {
      clearTimeout(this.pause);
      this.subscription.dispose();
      onDispose();
    });
    void this.load().catch(report);
  }

  dispose(): void {
    this.panel.dispose();
  }

  /** Shows the tab with a new history of the same variable. */
  reveal(history: HistoryBody): void {
    this.panel.reveal();
    this.show(history);
  }

  private async load(): Promise<void> {
    this.panel.webview.html = withPolicy(await readFile(this.page.fsPath, "utf8"));
  }

  private async take(message: FromPage): Promise<void> {
    if (message.command === "ready") {
      this.isReady = true;
      this.post({ kind: "history", history: this.history }, { kind: "note", note: this.note });
    } else if (message.command === "earlier") {
      this.count *= GROWTH;
      await this.refresh();
    } else {
      await vscode.commands.executeCommand("val3.openLine", message.source, !message.isFinal);
    }
  }

  private changeSession(): void {
    if (this.run.session === this.session) {
      this.refreshSoon();
    } else {
      this.setNote("This is the history of another debug session.");
    }
  }

  private resume(): void {
    clearTimeout(this.pause);
    this.isStale = false;
    this.setNote("The run continues. The history is updated at the next stop.");
  }

  private refreshSoon(): void {
    clearTimeout(this.pause);
    this.isStale = !this.panel.visible;
    if (this.panel.visible) {
      this.pause = setTimeout(() => void this.refresh().catch(this.report), PAUSE);
    }
  }

  /** Requests the history at the present moment. */
  private async refresh(): Promise<void> {
    if (this.run.session !== this.session) {
      return;
    }
    const request = ++this.request;
    try {
      const history = await this.run.request("val3/history", { dataId: this.history.name, count: this.count });
      if (history !== undefined && request === this.request) {
        this.show(history);
      }
    } catch (fault) {
      if (request === this.request) {
        this.setNote(historyFault(fault));
      }
    }
  }

  private show(history: HistoryBody): void {
    this.history = history;
    this.note = null;
    this.post({ kind: "history", history });
  }

  private setNote(note: string | null): void {
    this.note = note;
    this.post({ kind: "note", note });
  }

  private post(...messages: readonly ToPage[]): void {
    if (this.isReady) {
      messages.forEach((message) => void this.panel.webview.postMessage(message).then(undefined, this.report));
    }
  }
}

/** Formats the reason why a history is not available. */
export function historyFault(fault: unknown): string {
  const reason = fault instanceof Error ? fault.message : String(fault);
  if (reason === "notStopped") {
    return "The history is available while the run is stopped.";
  }
  // The application was opened again.
  return reason.endsWith("is not known in this run") ? `${reason}: show its history again from the view Variables` : reason;
}
