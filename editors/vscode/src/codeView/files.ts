// The file system of code views: a program's code, without its XML, as a file of its own.

import * as vscode from "vscode";
import { Link } from "./link";
import { codeUri, SCHEME } from "./uris";

export class CodeFiles implements vscode.FileSystemProvider, vscode.Disposable {
  private readonly changes = new vscode.EventEmitter<vscode.FileChangeEvent[]>();
  readonly onDidChangeFile = this.changes.event;
  private readonly links = new Map<string, Promise<Link>>();
  private readonly open = new Map<string, Link>();
  private readonly subscriptions: vscode.Disposable[];

  constructor() {
    this.subscriptions = [
      vscode.workspace.registerFileSystemProvider(SCHEME, this, { isCaseSensitive: true }),
      vscode.workspace.onDidChangeTextDocument(({ document, contentChanges }) => {
        if (contentChanges.length > 0) {
          void this.follow(document);
        }
      }),
      vscode.workspace.onDidSaveTextDocument((document) => void this.saved(document)),
      vscode.workspace.onDidCloseTextDocument((document) => this.forget(document.uri)),
    ];
  }

  dispose(): void {
    this.subscriptions.forEach((subscription) => subscription.dispose());
    this.changes.dispose();
  }

  /** The open code view with this address, or of the file with this address. */
  find(uri: string | vscode.Uri): Link | undefined {
    const parsed = typeof uri === "string" ? vscode.Uri.parse(uri) : uri;
    return this.open.get((parsed.scheme === SCHEME ? parsed : codeUri(parsed)).toString());
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

  watch(): vscode.Disposable {
    return new vscode.Disposable(() => undefined);
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

  private async follow(document: vscode.TextDocument): Promise<void> {
    const link = this.find(document.uri);
    await (document.uri.scheme === SCHEME ? link?.push() : link?.pull());
  }

  /** A view whose changes were saved with its file has no changes of its own left. */
  private async saved(document: vscode.TextDocument): Promise<void> {
    const view = document.uri.scheme === SCHEME ? undefined : this.find(document.uri)?.document();
    if (view?.isDirty === true) {
      await view.save();
    }
  }

  /** VS Code closes the document of a file that no editor shows: the view then opens it anew. */
  private forget(uri: vscode.Uri): void {
    const link = this.find(uri);
    if (link === undefined) {
      return;
    }
    const key = link.code.toString();
    this.links.delete(key);
    this.open.delete(key);
    if (uri.scheme !== SCHEME && link.document() !== undefined) {
      void this.link(link.code);
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
