// File system of code views: the code of a program, without its XML, as a separate file.

import * as vscode from "vscode";
import { Link } from "./link";
import { SCHEME } from "./uris";

export class CodeFiles implements vscode.FileSystemProvider, vscode.Disposable {
  private readonly changes = new vscode.EventEmitter<vscode.FileChangeEvent[]>();
  readonly onDidChangeFile = this.changes.event;
  private readonly links = new Map<string, Promise<Link>>();
  private readonly open = new Map<string, Link>();
  private readonly subscriptions: vscode.Disposable[];

  /** `report` receives the errors of background work. */
  constructor(private readonly report: (fault: unknown) => void) {
    this.subscriptions = [
      vscode.workspace.registerFileSystemProvider(SCHEME, this, { isCaseSensitive: true }),
      vscode.workspace.onDidChangeTextDocument(({ document, contentChanges }) => {
        if (contentChanges.length > 0) {
          this.follow(document).catch(this.report);
        }
      }),
      vscode.workspace.onDidSaveTextDocument((document) => void this.saved(document).catch(this.report)),
      vscode.workspace.onDidCloseTextDocument((document) => this.forget(document.uri)),
    ];
  }

  dispose(): void {
    vscode.Disposable.from(...this.subscriptions).dispose();
    this.changes.dispose();
  }

  /** Returns the open code view with this URI. */
  find(code: vscode.Uri): Link | undefined {
    return this.open.get(code.toString());
  }

  /** Returns the open code views of a file; for the URI of a code view, only that view. */
  of(uri: vscode.Uri): Link[] {
    const isOf = ({ code, file }: Link): boolean => (uri.scheme === SCHEME ? code : file.uri).toString() === uri.toString();
    return [...this.open.values()].filter(isOf);
  }

  /** Returns all open code views. */
  all(): Link[] {
    return [...this.open.values()];
  }

  async stat(uri: vscode.Uri): Promise<vscode.FileStat> {
    const link = await this.link(uri);
    const size = Buffer.byteLength(code(link));
    return { type: vscode.FileType.File, ctime: 0, mtime: link.changed, size };
  }

  async readFile(uri: vscode.Uri): Promise<Uint8Array> {
    return Buffer.from(code(await this.link(uri)));
  }

  async writeFile(uri: vscode.Uri, content: Uint8Array): Promise<void> {
    const link = await this.link(uri);
    await link.push(Buffer.from(content).toString());
    await link.save();
  }

  /** Changes are reported for all files, watched or not. */
  watch(): vscode.Disposable {
    return vscode.Disposable.from();
  }

  readDirectory(): [string, vscode.FileType][] {
    return [];
  }

  createDirectory(uri: vscode.Uri): never {
    throw vscode.FileSystemError.NoPermissions(uri);
  }

  delete(uri: vscode.Uri): never {
    throw vscode.FileSystemError.NoPermissions(uri);
  }

  rename(uri: vscode.Uri): never {
    throw vscode.FileSystemError.NoPermissions(uri);
  }

  private link(uri: vscode.Uri): Promise<Link> {
    const key = uri.toString();
    const known = this.links.get(key);
    if (known !== undefined) {
      return known;
    }
    const opening = Link.open(uri, (code) => this.changes.fire([{ type: vscode.FileChangeType.Changed, uri: code }]));
    this.links.set(key, opening);
    opening.then(
      (link) => this.open.set(key, link),
      () => this.links.delete(key),
    );
    return opening;
  }

  private async follow({ uri }: vscode.TextDocument): Promise<void> {
    await Promise.all(this.of(uri).map((link) => (uri.scheme === SCHEME ? link.push() : link.pull())));
  }

  /** Saves the changes of a file's views together with the file. */
  private async saved(document: vscode.TextDocument): Promise<void> {
    const views = document.uri.scheme === SCHEME ? [] : this.of(document.uri);
    const changed = views.flatMap((view) => view.document() ?? []).filter((view) => view.isDirty);
    await Promise.all(changed.map((view) => view.save()));
  }

  /** VS Code closes documents without an editor. The view then opens its file again. */
  private forget(uri: vscode.Uri): void {
    for (const link of this.of(uri)) {
      const key = link.code.toString();
      this.links.delete(key);
      this.open.delete(key);
      if (uri.scheme !== SCHEME && link.document() !== undefined) {
        this.link(link.code).catch(this.report);
      }
    }
  }
}

function code(link: Link): string {
  const text = link.text();
  if (text === undefined) {
    throw vscode.FileSystemError.Unavailable(`${link.file.uri.path} has no element <Code>.`);
  }
  return text;
}
