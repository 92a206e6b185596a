// Tables for a data file in a tab. The text document is the model: each change is a text edit.

import * as vscode from "vscode";
import type { Client } from "../client";
import { openDocument } from "../encoding/documents";
import { Conflicts } from "./conflict";
import { Edits, type Outcome } from "./edits";
import { rangeOf } from "../ranges";
import type { DataEdit } from "../serverRequests";
import { areChanges, changed, datumAt, Requests, type Tables } from "./requests";
import { openUse, type Use, usesOf } from "./uses";

/** Datum to show, by name or by a position in the text. */
export type Target = { name: string } | { position: vscode.Position };

interface FromPage {
  command: string;
  id?: number;
  [parameter: string]: unknown;
}

/** Milliseconds from a change to the update of the tables, in which further changes are collected. */
const PAUSE = 150;

export class DataPanel implements vscode.Disposable {
  private readonly requests: Requests;
  private readonly edits: Edits;
  private readonly subscriptions: vscode.Disposable[];
  private tables: Tables | undefined;
  private timer: NodeJS.Timeout | undefined;
  /** Serialises requests for tables. */
  private loading: Promise<void> = Promise.resolve();
  private isReady = false;
  /** Whether the file was changed while the tab was hidden. */
  private isStale = false;
  private target: Target | undefined;
  /** Datum with the active cell. */
  private selected: string | undefined;

  constructor(
    readonly document: vscode.TextDocument,
    readonly panel: vscode.WebviewPanel,
    client: Client,
    private readonly report: (fault: unknown) => void,
    private readonly onSelected: (name: string | undefined) => void,
  ) {
    this.requests = new Requests(client, document.uri);
    this.edits = new Edits(document, this.requests);
    const conflicts = new Conflicts(document, report);
    this.subscriptions = [
      new vscode.Disposable(() => conflicts.dispose()),
      client.onDidTellChange(() => this.changed()),
      client.onDidChangeState(() => this.changed()),
      panel.onDidChangeViewState(() => panel.visible && this.isStale && this.changed()),
      panel.webview.onDidReceiveMessage((message: FromPage) => void this.take(message).catch(report)),
    ];
  }

  dispose(): void {
    clearTimeout(this.timer);
    vscode.Disposable.from(...this.subscriptions).dispose();
  }

  /** Shows a datum as soon as the page is ready. */
  reveal(target: Target): void {
    this.target = target;
    this.showTarget();
  }

  /** Opens the text at the selected datum. */
  async openText(name = this.selected): Promise<void> {
    const range = this.tables?.data.find((datum) => datum.name === name)?.range;
    const { viewColumn } = this.panel;
    await vscode.window.showTextDocument(this.document.uri, { preview: false, ...(viewColumn && { viewColumn }), ...(range && { selection: rangeOf(range) }) });
  }

  private changed(): void {
    this.isStale = true;
    if (this.isReady && this.panel.visible && this.timer === undefined) {
      this.timer = setTimeout(() => {
        this.timer = undefined;
        this.refresh().catch(this.report);
      }, PAUSE);
    }
  }

  /** Sends the tables of the present text, or their changes. Findings may follow later, because they require a check. */
  private refresh(withoutFindings = false): Promise<void> {
    this.loading = this.loading.catch(() => undefined).then(() => this.load(withoutFindings));
    return this.loading;
  }

  private async load(withoutFindings: boolean): Promise<void> {
    this.isStale = withoutFindings;
    try {
      const result = await this.requests.tables(this.tables?.resultId, withoutFindings);
      if (result === null) {
        this.tables = undefined;
        this.post({ kind: "unavailable", reason: "The server does not know this file as the data of an application, a library or a type. Its text can be edited." });
      } else if (areChanges(result)) {
        this.tables = changed(this.tables ?? { resultId: "", version: null, data: [] }, result);
        this.post({ kind: "changes", changes: result });
        this.showTarget();
      } else {
        this.tables = result;
        this.post({ kind: "tables", tables: result });
        this.showTarget();
      }
    } catch (fault) {
      this.report(fault);
      this.post({ kind: "unavailable", reason: `The server does not answer, so that the tables are those of an earlier text or empty: ${messageOf(fault)}` });
    }
  }

  private showTarget(): void {
    if (this.target === undefined || this.tables === undefined || !this.isReady) {
      return;
    }
    const name = "name" in this.target ? this.target.name : datumAt(this.tables, this.target.position);
    this.target = undefined;
    if (name !== undefined) {
      this.post({ kind: "reveal", name });
    }
  }

  private async take(message: FromPage): Promise<void> {
    const { command, id } = message;
    if (id !== undefined) {
      await this.answer(message).then((answer) => this.post({ kind: "answer", id, answer }), (fault: unknown) => this.post({ kind: "answer", id, fault: messageOf(fault) }));
    } else if (command === "ready") {
      this.isReady = true;
      this.tables = undefined;
      await openDocument(this.document.uri);
      await this.refresh();
    } else if (command === "selected") {
      this.selected = message["name"] as string | undefined;
      this.onSelected(this.selected);
    } else if (command === "openText") {
      await this.openText(message["name"] as string | undefined);
    } else if (command === "openUse") {
      await openUse(message["use"] as Use);
    }
  }

  private async answer({ command, edits, check, name, as, names }: FromPage): Promise<unknown> {
    switch (command) {
      case "edit": return check === true ? this.edits.check(edits as readonly DataEdit[]) : this.withTables(this.edits.apply(edits as readonly DataEdit[]));
      case "rename": return this.withTables(this.rename(name as string, as as string));
      case "uses": return usesOf(this.document.uri, await this.present(), names as string[]);
      case "poses": return this.requests.poses(names as string[]);
      default: throw new Error(`The page has sent an unknown request: ${command}.`);
    }
  }

  private async rename(name: string, as: string): Promise<Outcome> {
    const range = (await this.present()).data.find((datum) => datum.name === name)?.range;
    return range === undefined ? { refused: `The file has no data ${name}.`, findings: [] } : this.edits.rename(rangeOf(range).start, as);
  }

  /** Returns the tables of the present text. */
  private async present(): Promise<Tables> {
    if (this.tables?.version !== this.document.version) {
      await this.refresh();
    }
    return this.tables ?? { resultId: "", version: null, data: [] };
  }

  /** Sends the new tables before the edit's result, so that the page shows them when it receives the result. */
  private async withTables(outcome: Promise<Outcome>): Promise<Outcome> {
    const { refused, findings } = await outcome;
    if (refused === null) {
      await this.refresh(true);
    }
    return { refused, findings };
  }

  private post(message: object): void {
    void this.panel.webview.postMessage(message);
  }
}

function messageOf(fault: unknown): string {
  return fault instanceof Error ? fault.message : String(fault);
}
