// Opens files in their declared encoding, and prevents the loss of characters on save.
//
// VS Code reads a file in the encoding of its settings and ignores the XML declaration. If a file in ISO-8859-1 is read
// as UTF-8, every accent is lost, and saving would make the loss permanent. A VAL 3 file is therefore read again in its
// declared encoding. If a file is edited before that, for example by "Replace in Files", its characters are restored on
// save.

import { readFile, writeFile } from "node:fs/promises";
import * as vscode from "vscode";
import { encodingsOf, isDeclaredAlike, isSameEncoding, isUtf8, LATIN1 } from "./declared";
import type { Replacement } from "../codeView/projection";
import { asReferences, asUtf8, LOST, restore } from "./rescue";

const LANGUAGES = new Set(["val3", "val3-data", "val3-project"]);

/** Highest number of attempts to read a file in its encoding. Each reload by VS Code can undo one. */
const MOST_READS = 10;

/**
 * Documents that VS Code reads again, or that were edited meanwhile and not saved since. Edited documents have the new
 * encoding, but still contain the text that was read as UTF-8.
 */
const rereads = new WeakMap<vscode.TextDocument, Promise<vscode.TextDocument>>();

/** Opens a file in its own encoding. */
export async function openDocument(uri: vscode.Uri): Promise<vscode.TextDocument> {
  const document = await vscode.workspace.openTextDocument(uri);
  const { version } = document;
  const encoding = await missedEncoding(document);
  // If the document was edited and saved meanwhile, the bytes on the disk are no longer the examined bytes.
  const isUntouched = !document.isDirty && document.version === version;
  if (encoding !== undefined && isUntouched && !rereads.has(document)) {
    rereads.set(document, readAgain(document, encoding));
  }
  return rereads.get(document) ?? document;
}

async function readAgain(document: vscode.TextDocument, encoding: string): Promise<vscode.TextDocument> {
  let isEdited = false;
  try {
    const read = await readIn(document.uri, encoding);
    isEdited = document.isDirty;
    return read;
  } finally {
    if (!isEdited) {
      rereads.delete(document);
    }
  }
}

/**
 * Reads a file again in an encoding. If VS Code is already reloading the file in its previous encoding, because the file has
 * changed on the disk, and ends first, it discards the new text and encoding: then the file is read once more.
 */
async function readIn(uri: vscode.Uri, encoding: string): Promise<vscode.TextDocument> {
  let document = await vscode.workspace.openTextDocument(uri, { encoding });
  for (let reads = 1; reads < MOST_READS && !document.isDirty && !isSameEncoding(encoding, document.encoding); reads += 1) {
    document = await vscode.workspace.openTextDocument(uri, { encoding });
  }
  return document;
}

/** `report` receives the errors of background work. */
export function registerEncodings(report: (fault: unknown) => void): vscode.Disposable[] {
  const saves = new Saves();
  const correct = ({ uri }: vscode.TextDocument): void => void openDocument(uri).catch(report);
  vscode.workspace.textDocuments.filter(isOwn).forEach(correct);
  return [
    vscode.workspace.onDidOpenTextDocument((document) => isOwn(document) && correct(document)),
    vscode.workspace.onWillSaveTextDocument((event) => isOwn(event.document) && event.waitUntil(saves.prepare(event.document))),
    vscode.workspace.onDidSaveTextDocument((document) => isOwn(document) && void saves.finish(document).catch(report)),
  ];
}

function isOwn({ uri, languageId, encoding }: vscode.TextDocument): boolean {
  return uri.scheme === "file" && LANGUAGES.has(languageId) && !encoding.startsWith("utf16");
}

/** Returns the file's encoding, if the document was read in a different one. */
async function missedEncoding(document: vscode.TextDocument): Promise<string | undefined> {
  if (!isOwn(document)) {
    return undefined;
  }
  const encoding = await encodingOf(await readFile(document.uri.fsPath));
  return encoding === undefined || isSameEncoding(encoding, document.encoding) ? undefined : encoding;
}

/** Returns the first encoding that keeps all bytes. */
async function encodingOf(bytes: Uint8Array): Promise<string | undefined> {
  for (const encoding of encodingsOf(bytes)) {
    if (isUtf8(encoding) || Buffer.compare(await encode(await decode(bytes, encoding), encoding), bytes) === 0) {
      return encoding;
    }
  }
  return undefined;
}

class Saves {
  /** Right encodings of files that VS Code is about to save wrongly, by URI. */
  private readonly pending = new Map<string, string>();

  /** Returns the edits that prevent a loss of characters on save. */
  async prepare(document: vscode.TextDocument): Promise<vscode.TextEdit[]> {
    const text = Buffer.from(document.getText());
    // A file that does not exist yet has lost nothing.
    const bytes = await readFile(document.uri.fsPath).catch(() => text);
    const encoding = bytes === text ? document.encoding : await encodingOf(bytes);
    if (encoding === undefined) {
      return [];
    }
    const wanted = bytes !== text && isDeclaredAlike(bytes, text) ? encoding : (encodingsOf(text)[0] ?? encoding);
    if (!isSameEncoding(wanted, document.encoding)) {
      this.pending.set(document.uri.toString(), wanted);
    }
    if (!isSameEncoding(encoding, document.encoding)) {
      return restored(document, bytes, document.encoding, encoding);
    }
    if (rereads.has(document) && document.getText().includes(LOST)) {
      return restored(document, bytes, "utf8", encoding);
    }
    return this.fit(document, wanted);
  }

  /** Saves a file again if VS Code has saved it in the wrong encoding. */
  async finish(document: vscode.TextDocument): Promise<void> {
    rereads.delete(document);
    const encoding = this.take(document) ?? document.encoding;
    if (document.isDirty || (isUtf8(document.encoding) && isUtf8(encoding))) {
      return;
    }
    const edits = await this.fit(document, encoding);
    const wanted = this.take(document) ?? encoding;
    if (edits.length > 0) {
      await replace(document, edits);
    } else if (!isSameEncoding(wanted, document.encoding)) {
      await writeFile(document.uri.fsPath, await encode(document.getText(), wanted));
      await readIn(document.uri, wanted);
    }
  }

  private take({ uri }: vscode.TextDocument): string | undefined {
    const encoding = this.pending.get(uri.toString());
    this.pending.delete(uri.toString());
    return encoding;
  }

  /**
   * Returns the edits for characters that an encoding does not contain: references, or a change of the file's encoding
   * to UTF-8.
   */
  private async fit(document: vscode.TextDocument, encoding: string): Promise<vscode.TextEdit[]> {
    const text = document.getText();
    if (isUtf8(encoding)) {
      return isUtf8(document.encoding) ? [] : edits(document, asUtf8(text));
    }
    const missing = await missingLetters(text, encoding);
    const references = asReferences(text, (letter) => !missing.has(letter));
    if (references === undefined) {
      this.pending.set(document.uri.toString(), "utf8");
      void vscode.window.showInformationMessage(`${vscode.workspace.asRelativePath(document.uri)} is saved in UTF-8: `
        + `${encoding} does not have ${[...missing].join(" ")}.`);
    }
    return edits(document, references ?? asUtf8(text));
  }
}

/** Applies edits that were not ready in time for the last save, and saves again. */
async function replace(document: vscode.TextDocument, edits: vscode.TextEdit[]): Promise<void> {
  const edit = new vscode.WorkspaceEdit();
  edit.set(document.uri, edits);
  if (await vscode.workspace.applyEdit(edit)) {
    await document.save();
  }
}

/**
 * Returns the edits of a document that was read in the encoding `read` and edited, although its file is in `encoding`:
 * they restore the document's characters, or otherwise the text of the file.
 */
async function restored(document: vscode.TextDocument, bytes: Uint8Array, read: string, encoding: string): Promise<vscode.TextEdit[]> {
  const right = await decode(bytes, encoding);
  const text = restore(document.getText(), await decode(bytes, read), right);
  if (text === undefined) {
    void vscode.window.showErrorMessage(`${vscode.workspace.asRelativePath(document.uri)} was not changed: it was opened as `
      + `${read}, but its encoding is ${encoding}, and characters would have been lost. Make the change again.`);
  }
  return [vscode.TextEdit.replace(whole(document), text ?? right)];
}

/** Returns the letters of a text that an encoding does not contain. */
async function missingLetters(text: string, encoding: string): Promise<Set<string>> {
  const letters = [...new Set(text)].filter((letter) => letter > "\x7f");
  const kept = (await decode(await encode(letters.join("\n"), encoding), encoding)).split("\n");
  return new Set(letters.filter((letter, index) => letter !== kept[index]));
}

function edits(document: vscode.TextDocument, replacements: Replacement[]): vscode.TextEdit[] {
  return replacements.map(({ start, end, text }) =>
    vscode.TextEdit.replace(new vscode.Range(document.positionAt(start), document.positionAt(end)), text),
  );
}

function whole(document: vscode.TextDocument): vscode.Range {
  return document.validateRange(new vscode.Range(0, 0, document.lineCount, 0));
}

/** Decodes the bytes of a file in its own encoding, like `openDocument`. */
export async function decodeFile(bytes: Uint8Array): Promise<string> {
  const encoding = await encodingOf(bytes);
  // Without an encoding, a byte order mark decides, which VS Code detects.
  return encoding === undefined ? vscode.workspace.decode(bytes) : decode(bytes, encoding);
}

// VS Code saves without edits that take too long, so the usual encodings are converted here.

async function decode(bytes: Uint8Array, encoding: string): Promise<string> {
  if (isUtf8(encoding) || encoding === LATIN1) {
    return isUtf8(encoding) ? new TextDecoder().decode(bytes) : Buffer.from(bytes).toString("latin1");
  }
  return vscode.workspace.decode(bytes, { encoding });
}

async function encode(text: string, encoding: string): Promise<Uint8Array> {
  return encoding === LATIN1 ? Buffer.from(text, "latin1") : vscode.workspace.encode(text, { encoding });
}
