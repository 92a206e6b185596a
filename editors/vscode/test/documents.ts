// Stand-in for the documents of VS Code: they are read, read again in another encoding, edited and saved.

import { readFile, writeFile } from "node:fs/promises";
import type { Uri } from "./vscode";

/** Setting `files.encoding` of the extension. */
const DEFAULT_ENCODING = "utf8bom";

export class Position {
  constructor(readonly line: number, readonly character: number) {}
}

export class Range {
  readonly start: Position;
  readonly end: Position;

  constructor(...ends: [Position, Position] | [number, number, number, number]) {
    [this.start, this.end] = ends.length === 2 ? ends : [new Position(ends[0], ends[1]), new Position(ends[2], ends[3])];
  }
}

export class TextEdit {
  constructor(readonly range: Range, readonly newText: string) {}

  static replace(range: Range, text: string): TextEdit {
    return new TextEdit(range, text);
  }
}

export class WorkspaceEdit {
  readonly changes: [Uri, TextEdit[]][] = [];

  set(uri: Uri, edits: TextEdit[]): void {
    this.changes.push([uri, edits]);
  }
}

class Emitter<T> {
  private readonly listeners = new Set<(value: T) => void>();
  readonly event = (listener: (value: T) => void): { dispose: () => void } => {
    this.listeners.add(listener);
    return { dispose: () => void this.listeners.delete(listener) };
  };

  fire(value: T): void {
    this.listeners.forEach((listener) => listener(value));
  }
}

interface WillSave {
  document: TextDocument;
  waitUntil: (edits: Promise<TextEdit[]>) => void;
}

const opened = new Emitter<TextDocument>();
const willSave = new Emitter<WillSave>();
const saved = new Emitter<TextDocument>();
const open = new Map<string, TextDocument>();
/** Resolves when documents may be read again. */
let disk = Promise.resolve();
/** Number of reloads, after changes on the disk, that are before those in another encoding. */
let reloads = 0;

export class TextDocument {
  readonly languageId = "val3";
  isDirty = false;
  version = 1;
  private text = "";

  constructor(readonly uri: Uri, public encoding: string) {}

  getText(): string {
    return this.text;
  }

  get lineCount(): number {
    return this.text.split("\n").length;
  }

  positionAt(offset: number): Position {
    const lines = this.text.slice(0, offset).split("\n");
    return new Position(lines.length - 1, lines.at(-1)?.length ?? 0);
  }

  /** Every range is valid here. */
  validateRange(range: Range): Range {
    return range;
  }

  async read(): Promise<void> {
    this.text = decodeAs(await readFile(this.uri.fsPath), this.encoding);
  }

  /**
   * As in VS Code, the new encoding is set immediately, and the text is kept if it was edited while the file was read. A
   * reload that began before restores the previous encoding, and cancels this one.
   */
  async readAgain(encoding: string): Promise<void> {
    const before = this.encoding;
    this.encoding = encoding;
    await disk;
    if (reloads > 0) {
      reloads -= 1;
      this.encoding = before;
      await this.read();
    } else if (!this.isDirty) {
      await this.read();
    }
  }

  /** Edits the document like a user or "Replace in Files". */
  replace(before: string, now: string): void {
    this.change(this.text.replace(before, now));
  }

  apply(edits: TextEdit[]): void {
    const changes = edits.map(({ range, newText }) => ({ start: this.offset(range.start), end: this.offset(range.end), newText }));
    changes.sort((left, right) => right.start - left.start);
    this.change(changes.reduce((text, { start, end, newText }) => text.slice(0, start) + newText + text.slice(end), this.text));
  }

  async save(): Promise<boolean> {
    const edits: Promise<TextEdit[]>[] = [];
    willSave.fire({ document: this, waitUntil: (promise) => edits.push(promise) });
    for (const promise of edits) {
      this.apply(await promise);
    }
    await writeFile(this.uri.fsPath, encodeAs(this.text, this.encoding));
    this.isDirty = false;
    saved.fire(this);
    return true;
  }

  close(): void {
    open.delete(this.uri.toString());
  }

  private change(text: string): void {
    this.isDirty ||= text !== this.text;
    this.version += 1;
    this.text = text;
  }

  private offset({ line, character }: Position): number {
    const before = this.text.split("\n").slice(0, line);
    return Math.min(before.reduce((sum, text) => sum + text.length + 1, 0) + character, this.text.length);
  }
}

/** Fires when the user trusts the folder. */
export const trusted = new Emitter<void>();

export const workspace = {
  isTrusted: true,
  onDidGrantWorkspaceTrust: trusted.event,
  onDidOpenTextDocument: opened.event,
  onWillSaveTextDocument: willSave.event,
  onDidSaveTextDocument: saved.event,
  get textDocuments(): TextDocument[] {
    return [...open.values()];
  },

  async openTextDocument(uri: Uri, options?: { encoding: string }): Promise<TextDocument> {
    const known = open.get(uri.toString());
    if (known !== undefined) {
      await (options && known.readAgain(options.encoding));
      return known;
    }
    const document = new TextDocument(uri, options?.encoding ?? DEFAULT_ENCODING);
    open.set(uri.toString(), document);
    await document.read();
    opened.fire(document);
    return document;
  },

  applyEdit(edit: WorkspaceEdit): Promise<boolean> {
    edit.changes.forEach(([uri, edits]) => open.get(uri.toString())?.apply(edits));
    return Promise.resolve(true);
  },

  asRelativePath: ({ path }: Uri): string => path.slice(path.lastIndexOf("/") + 1),
  decode: (bytes: Uint8Array, { encoding }: { encoding: string }) => Promise.resolve(decodeAs(bytes, encoding)),
  encode: (text: string, { encoding }: { encoding: string }) => Promise.resolve(encodeAs(text, encoding)),
};

/** Messages since the last call of `takeMessages`. */
const messages: string[] = [];
export const takeMessages = (): string[] => messages.splice(0);
const show = (text: string): Promise<void> => {
  messages.push(text);
  return Promise.resolve();
};
export const window = { showErrorMessage: show, showInformationMessage: show, showWarningMessage: show };

/** Delays the reading of documents until the returned function is called. */
export function holdDisk(): () => void {
  let release = (): void => undefined;
  disk = new Promise((resolve) => (release = resolve));
  return release;
}

/** Lets VS Code reload documents, after changes on the disk, before it reads them in another encoding. */
export function reloadFirst(count: number): void {
  reloads = count;
}

function decodeAs(bytes: Uint8Array, encoding: string): string {
  return encoding === "iso88591" ? Buffer.from(bytes).toString("latin1") : new TextDecoder(labelOf(encoding)).decode(bytes);
}

/** As in VS Code, a character that the encoding does not contain becomes a question mark. */
function encodeAs(text: string, encoding: string): Buffer {
  if (encoding.startsWith("utf8")) {
    return Buffer.from(text);
  }
  const letters = decodeAs(Uint8Array.from({ length: 256 }, (_, byte) => byte), encoding);
  return Buffer.from(Array.from(text, (letter) => letters.includes(letter) ? letters.indexOf(letter) : "?".charCodeAt(0)));
}

function labelOf(encoding: string): string {
  return encoding.startsWith("utf8") ? "utf-8" : encoding.replace("windows", "windows-");
}
