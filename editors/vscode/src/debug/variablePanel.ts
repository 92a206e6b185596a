// Tab with values of a variable: its history as a list and a plot, or the elements of an array as a table.

import { readFile } from "node:fs/promises";
import * as vscode from "vscode";
import type { HistoryBody, TableBody, WriteLine } from "./requests";
import type { DebuggedRun } from "./run";
import { withPolicy } from "./view/page";

const TYPE = "val3.history";

/** Number of requested writes or elements at first, and factor for each request of more. */
const [COUNT, GROWTH] = [1000, 10];

/** Milliseconds after a stop until the values are requested, so that the search of a history does not delay quick steps. */
const PAUSE = 200;

/** Message from the page. */
type FromPage = { command: "ready" } | { command: "openLine"; source: WriteLine; isFinal: boolean } | { command: "more" };

/** Values in a tab. */
type Contents = { kind: "history"; history: HistoryBody } | { kind: "table"; table: TableBody };

type ToPage = Contents | { kind: "note"; note: string | null };

/** Variable of a request: by its name in a scope, or by its full name. */
export type VariableArguments = { name: string; variablesReference: number | null } | { dataId: string };

/** Kind of a tab. */
export interface TabKind {
  /** Noun in messages: `history`. */
  noun: string;
  title: (name: string) => string;
  /** Returns the values, and the full name of the variable. */
  request: (run: DebuggedRun, variable: VariableArguments, count: number) => Promise<VariableValues | undefined>;
}

export interface VariableValues {
  /** Full name of the variable. */
  name: string;
  contents: Contents;
}

export const HISTORY: TabKind = {
  noun: "history",
  title: (name) => `History of ${name}`,
  request: async (run, variable, count) => {
    const history = await run.request("val3/history", { ...variable, count });
    return history === undefined ? undefined : { name: history.name, contents: { kind: "history", history } };
  },
};

export const TABLE: TabKind = {
  noun: "table",
  title: (name) => `Table of ${name}`,
  request: async (run, variable, count) => {
    const table = await run.request("val3/table", { ...variable, count });
    return table === undefined ? undefined : { name: table.name, contents: { kind: "table", table } };
  },
};

/** Returns the first values of a variable. */
export async function firstValues(kind: TabKind, run: DebuggedRun, variable: VariableArguments): Promise<VariableValues | undefined> {
  return kind.request(run, variable, COUNT);
}

export class VariablePanel implements vscode.Disposable {
  private readonly panel: vscode.WebviewPanel;
  /** Debug session to which the values belong. */
  private readonly session: vscode.DebugSession | undefined;
  private readonly subscription: vscode.Disposable;
  private isReady = false;
  /** Number of writes or elements of the next request. */
  private count = COUNT;
  /** Number of the last request. Responses to earlier ones are ignored. */
  private request = 0;
  private note: string | null = null;
  private pause: NodeJS.Timeout | undefined;
  /** Whether the run has stopped elsewhere while the tab was hidden. Values of a hidden tab are not requested. */
  private isStale = false;

  constructor(
    private readonly kind: TabKind,
    private readonly run: DebuggedRun,
    private readonly page: vscode.Uri,
    private values: VariableValues,
    private readonly report: (fault: unknown) => void,
    onDispose: () => void,
  ) {
    this.session = run.session;
    const options = { enableScripts: true, retainContextWhenHidden: true, localResourceRoots: [] };
    this.panel = vscode.window.createWebviewPanel(TYPE, kind.title(values.name), vscode.ViewColumn.Beside, options);
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

  /** Shows the tab with new values of the same variable. */
  reveal(values: VariableValues): void {
    this.panel.reveal();
    this.show(values);
  }

  private async load(): Promise<void> {
    this.panel.webview.html = withPolicy(await readFile(this.page.fsPath, "utf8"));
  }

  private async take(message: FromPage): Promise<void> {
    if (message.command === "ready") {
      this.isReady = true;
      this.post(this.values.contents, { kind: "note", note: this.note });
    } else if (message.command === "more") {
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
      this.setNote(`This is the ${this.kind.noun} of another debug session.`);
    }
  }

  private resume(): void {
    clearTimeout(this.pause);
    this.isStale = false;
    this.setNote(`The run continues. The ${this.kind.noun} is updated at the next stop.`);
  }

  private refreshSoon(): void {
    clearTimeout(this.pause);
    this.isStale = !this.panel.visible;
    if (this.panel.visible) {
      this.pause = setTimeout(() => void this.refresh().catch(this.report), PAUSE);
    }
  }

  /** Requests the values at the present moment. */
  private async refresh(): Promise<void> {
    if (this.run.session !== this.session) {
      return;
    }
    const request = ++this.request;
    try {
      const values = await this.kind.request(this.run, { dataId: this.values.name }, this.count);
      if (values !== undefined && request === this.request) {
        this.show(values);
      }
    } catch (fault) {
      if (request === this.request) {
        this.setNote(tabFault(fault, this.kind));
      }
    }
  }

  private show(values: VariableValues): void {
    this.values = values;
    this.note = null;
    this.post(values.contents);
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

/** Formats the reason why values are not available. */
export function tabFault(fault: unknown, { noun }: TabKind): string {
  const reason = fault instanceof Error ? fault.message : String(fault);
  if (reason === "notStopped") {
    return `The ${noun} is available while the run is stopped.`;
  }
  // The application was opened again.
  return reason.endsWith("is not known in this run") ? `${reason}: show its ${noun} again from the view Variables` : reason;
}
