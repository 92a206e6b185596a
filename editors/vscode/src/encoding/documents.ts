// Opens files in the encoding that they declare, and sees to it that saving one loses nothing.
//
// VS Code reads a file as its settings say, which know nothing of the XML declaration: in UTF-8, every accent of a file
// in ISO-8859-1 is lost, and saving makes that final. So a file of VAL 3 is read again as it declares. One that changed
// before that, as "Replace in Files" does it, gets its characters back when it is saved.

import { readFile, writeFile } from "node:fs/promises";
import * as vscode from "vscode";
import { encodingsOf, isDeclaredAlike, isSameEncoding, isUtf8, LATIN1 } from "./declared";
import type { Replacement } from "../codeView/projection";
import { asReferences, asUtf8, LOST, restore } from "./rescue";

const LANGUAGES = new Set(["val3", "val3-data", "val3-project"]);

/** Opens a file in its own encoding. */
export async function openDocument(uri: vscode.Uri): Promise<vscode.TextDocument> {
  const document = await vscode.workspace.openTextDocument(uri);
  const encoding = await missedEncoding(document);
  return encoding === undefined || document.isDirty ? document : vscode.workspace.openTextDocument(uri, { encoding });
}

/** `report` is told what fails while nobody waits for it. */
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

/** The encoding of a file, where its document has another. */
async function missedEncoding(document: vscode.TextDocument): Promise<string | undefined> {
  if (!isOwn(document)) {
    return undefined;
  }
  const encoding = await encodingOf(await readFile(document.uri.fsPath));
  return encoding === undefined || isSameEncoding(encoding, document.encoding) ? undefined : encoding;
}

/** The first encoding in which all bytes survive. */
async function encodingOf(bytes: Uint8Array): Promise<string | undefined> {
  for (const encoding of encodingsOf(bytes)) {
    if (isUtf8(encoding) || Buffer.compare(await encode(await decode(bytes, encoding), encoding), bytes) === 0) {
      return encoding;
    }
  }
  return undefined;
}

class Saves {
  /** Encodings of files that VS Code is about to save in another one, by their addresses. */
  private readonly pending = new Map<string, string>();

  /** The edits without which saving would lose characters. */
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
      return restored(document, bytes, encoding);
    }
    const late = bytes === text ? undefined : await editedBeforeReread(document, bytes, encoding);
    return late ?? this.fit(document, wanted);
  }

  /** Saves a file once more where VS Code could not save it as it should be. */
  async finish(document: vscode.TextDocument): Promise<void> {
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
      await vscode.workspace.openTextDocument(document.uri, { encoding: wanted });
    }
  }

  private take({ uri }: vscode.TextDocument): string | undefined {
    const encoding = this.pending.get(uri.toString());
    this.pending.delete(uri.toString());
    return encoding;
  }

  /** The edits for characters that an encoding does not have: references, or else another encoding for the file. */
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

/** Makes edits that came too late for the save before, and saves them. */
async function replace(document: vscode.TextDocument, edits: vscode.TextEdit[]): Promise<void> {
  const edit = new vscode.WorkspaceEdit();
  edit.set(document.uri, edits);
  if (await vscode.workspace.applyEdit(edit)) {
    await document.save();
  }
}

/** The text of a document that was changed in the wrong encoding, or else what its file holds. */
async function restored(document: vscode.TextDocument, bytes: Uint8Array, encoding: string): Promise<vscode.TextEdit[]> {
  const right = await decode(bytes, encoding);
  const text = restore(document.getText(), await decode(bytes, document.encoding), right);
  if (text === undefined) {
    void vscode.window.showErrorMessage(`${vscode.workspace.asRelativePath(document.uri)} was not changed: it was opened as `
      + `${document.encoding}, but holds ${encoding}, and characters would have been lost. Make the change once more.`);
  }
  return [vscode.TextEdit.replace(whole(document), text ?? right)];
}

/**
 * The edit for a document that was changed while VS Code read it again: VS Code has set the new encoding by then, but
 * keeps the text that it had read as UTF-8. Nothing where no character was lost.
 */
async function editedBeforeReread(document: vscode.TextDocument, bytes: Uint8Array, encoding: string): Promise<vscode.TextEdit[] | undefined> {
  if (isUtf8(encoding) || !document.getText().includes(LOST)) {
    return undefined;
  }
  const text = restore(document.getText(), await decode(bytes, "utf8"), await decode(bytes, encoding));
  return text === undefined ? undefined : [vscode.TextEdit.replace(whole(document), text)];
}

/** The letters of a text that an encoding does not have. */
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

// VS Code saves without the edits that it has to wait for too long, so the usual encodings are done here.

async function decode(bytes: Uint8Array, encoding: string): Promise<string> {
  if (isUtf8(encoding) || encoding === LATIN1) {
    return isUtf8(encoding) ? new TextDecoder().decode(bytes) : Buffer.from(bytes).toString("latin1");
  }
  return vscode.workspace.decode(bytes, { encoding });
}

async function encode(text: string, encoding: string): Promise<Uint8Array> {
  return encoding === LATIN1 ? Buffer.from(text, "latin1") : vscode.workspace.encode(text, { encoding });
}
