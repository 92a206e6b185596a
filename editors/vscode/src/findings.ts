// Lists each finding once, although a file and its code view both contain its code.
//
// While a code view has a tab, findings in the code are listed for the view, and all other findings for its file. While
// the file is the active editor, all findings are listed there.

import * as vscode from "vscode";
import type { DiagnosticCollectionProvider } from "vscode-languageclient/node";
import type { CodeFiles } from "./codeView/files";
import type { Link } from "./codeView/link";
import { SCHEME } from "./codeView/uris";

type Entries = readonly [vscode.Uri, readonly vscode.Diagnostic[] | undefined][];

/** Creates collections for the language client that divide findings between files and views. */
export class Findings implements DiagnosticCollectionProvider, vscode.Disposable {
  private readonly collections = new Set<SharedCollection>();
  private readonly subscriptions: vscode.Disposable[];

  constructor(private readonly views: CodeFiles) {
    const share = (): void => this.collections.forEach((collection) => collection.share());
    this.subscriptions = [vscode.window.tabGroups.onDidChangeTabs(share), vscode.window.onDidChangeActiveTextEditor(share)];
  }

  create(name?: string): vscode.DiagnosticCollection {
    const collection = new SharedCollection(vscode.languages.createDiagnosticCollection(name), this.views);
    this.collections.add(collection);
    return collection;
  }

  dispose(collection?: vscode.DiagnosticCollection): void {
    if (collection === undefined) {
      vscode.Disposable.from(...this.subscriptions, ...this.collections).dispose();
    } else if (collection instanceof SharedCollection) {
      this.collections.delete(collection);
      collection.dispose();
    }
  }
}

class SharedCollection implements vscode.DiagnosticCollection {
  readonly name: string;
  /** Findings from the server. A view has none until the server was queried about it. */
  private readonly found = new Map<string, readonly vscode.Diagnostic[]>();

  constructor(private readonly shown: vscode.DiagnosticCollection, private readonly views: CodeFiles) {
    this.name = shown.name;
  }

  set(place: vscode.Uri | Entries, diagnostics?: readonly vscode.Diagnostic[]): void {
    const entries: Entries = place instanceof vscode.Uri ? [[place, diagnostics]] : place;
    for (const [uri, found] of entries) {
      this.found.set(uri.toString(), found ?? []);
      this.show(uri);
    }
  }

  delete(uri: vscode.Uri): void {
    this.found.delete(uri.toString());
    this.show(uri);
  }

  clear(): void {
    this.found.clear();
    this.shown.clear();
  }

  /** Divides all findings once more. */
  share(): void {
    this.views.all().forEach((link) => this.show(link.code));
  }

  get(uri: vscode.Uri): readonly vscode.Diagnostic[] | undefined {
    return this.shown.get(uri);
  }

  has(uri: vscode.Uri): boolean {
    return this.shown.has(uri);
  }

  forEach(callback: (uri: vscode.Uri, diagnostics: readonly vscode.Diagnostic[], collection: vscode.DiagnosticCollection) => void): void {
    this.shown.forEach((uri, diagnostics) => callback(uri, diagnostics, this));
  }

  [Symbol.iterator](): Iterator<[vscode.Uri, readonly vscode.Diagnostic[]]> {
    return this.shown[Symbol.iterator]();
  }

  dispose(): void {
    this.found.clear();
    this.shown.dispose();
  }

  /** Divides the findings of a file or view between the file and its views. */
  private show(uri: vscode.Uri): void {
    const links = this.views.of(uri);
    const file = uri.scheme === SCHEME ? links[0]?.file.uri : uri;
    if (file === undefined) {
      this.shown.delete(uri);
      return;
    }
    const ofFile = this.found.get(file.toString()) ?? [];
    const leading = this.views.of(file).filter(leads);
    for (const link of this.views.of(file)) {
      const ofView = this.found.get(link.code.toString()) ?? inCode(link, ofFile);
      this.shown.set(link.code, leading.includes(link) ? ofView : []);
    }
    this.shown.set(file, ofFile.filter(({ range }) => !leading.some((link) => link.mapping()?.rangeToCode(range))));
  }
}

/** Whether the view has a tab and its file is not the active editor. */
function leads({ code, file }: Link): boolean {
  const tabs = vscode.window.tabGroups.all.flatMap((group) => group.tabs);
  const isShown = tabs.some(({ input }) => input instanceof vscode.TabInputText && input.uri.toString() === code.toString());
  return isShown && vscode.window.activeTextEditor?.document.uri.toString() !== file.uri.toString();
}

function inCode(link: Link, diagnostics: readonly vscode.Diagnostic[]): vscode.Diagnostic[] {
  const mapping = link.mapping();
  return diagnostics.flatMap((diagnostic) => {
    const range = mapping?.rangeToCode(diagnostic.range);
    if (range === undefined) {
      return [];
    }
    const { start, end } = range;
    const place = new vscode.Range(start.line, start.character, end.line, end.character);
    return [Object.assign(new vscode.Diagnostic(place, diagnostic.message, diagnostic.severity), {
      code: diagnostic.code,
      source: diagnostic.source,
      tags: diagnostic.tags,
      relatedInformation: diagnostic.relatedInformation,
    })];
  });
}
