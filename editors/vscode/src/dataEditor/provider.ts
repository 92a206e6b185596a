// Custom editor of data files, and the commands that switch between tables and text.

import { readFile } from "node:fs/promises";
import * as vscode from "vscode";
import type { Client } from "../client";
import { uriOf } from "../codeView/uris";
import { withPolicy } from "../debug/view/page";
import { openDocument } from "../encoding/documents";
import { DataPanel, type Target } from "./panel";

const TYPE = "val3.dataEditor";
const LANGUAGE = "val3-data";

export function registerDataEditor(context: vscode.ExtensionContext, client: Client, report: (fault: unknown) => void, onSelected: (name: string | undefined) => void): vscode.Disposable[] {
  const editors = new DataEditors(client, vscode.Uri.joinPath(context.extensionUri, "dist", "data.html"), report, onSelected);
  return [
    vscode.window.registerCustomEditorProvider(TYPE, editors, { webviewOptions: { retainContextWhenHidden: true } }),
    vscode.commands.registerCommand("val3.openData", (target?: unknown, name?: unknown) => editors.open(target, name)),
    vscode.commands.registerCommand("val3.openDataFile", () => editors.openText()),
  ];
}

/** Item of the view "VAL 3". */
interface TreeNode {
  item: vscode.TreeItem;
}

class DataEditors implements vscode.CustomTextEditorProvider {
  private readonly panels = new Set<DataPanel>();
  /** Data to show in tabs that are being opened, by URI. */
  private readonly targets = new Map<string, Target>();

  constructor(
    private readonly client: Client,
    private readonly page: vscode.Uri,
    private readonly report: (fault: unknown) => void,
    private readonly onSelected: (name: string | undefined) => void,
  ) {}

  async resolveCustomTextEditor(document: vscode.TextDocument, panel: vscode.WebviewPanel): Promise<void> {
    panel.webview.options = { enableScripts: true, localResourceRoots: [] };
    const shown = new DataPanel(document, panel, this.client, this.report, this.onSelected);
    this.panels.add(shown);
    panel.onDidDispose(() => {
      this.panels.delete(shown);
      shown.dispose();
    });
    const key = document.uri.toString();
    const target = this.targets.get(key);
    this.targets.delete(key);
    if (target !== undefined) {
      shown.reveal(target);
    }
    panel.webview.html = withPolicy(await readFile(this.page.fsPath, "utf8"));
  }

  /** Opens a data file as tables, at the named datum or at the cursor. `target` is a URI or an item of a view. */
  async open(target: unknown, name: unknown): Promise<void> {
    const editor = vscode.window.activeTextEditor;
    const uri = uriOf(isNode(target) ? target.item.resourceUri : target) ?? (await dataFile(editor));
    if (uri === undefined) {
      return;
    }
    const isHere = editor?.document.uri.toString() === uri.toString();
    const shown: Target | undefined = typeof name === "string" ? { name } : isHere ? { position: editor.selection.active } : undefined;
    await openDocument(uri);
    const key = uri.toString();
    if (shown !== undefined) {
      this.targets.set(key, shown);
    }
    await vscode.commands.executeCommand("vscode.openWith", uri, TYPE);
    // The tab may have been open already, so that no new panel has taken the target.
    const panel = [...this.panels].findLast(({ document }) => document.uri.toString() === key);
    const pending = this.targets.get(key);
    if (panel !== undefined && pending !== undefined) {
      this.targets.delete(key);
      panel.reveal(pending);
    }
  }

  /** Opens the text of the active tables. */
  async openText(): Promise<void> {
    await [...this.panels].find(({ panel }) => panel.active)?.openText();
  }
}

function isNode(target: unknown): target is TreeNode {
  return typeof target === "object" && target !== null && "item" in target;
}

/** Returns the data file in the editor, or one that the user selects. */
async function dataFile(editor: vscode.TextEditor | undefined): Promise<vscode.Uri | undefined> {
  if (editor?.document.languageId === LANGUAGE) {
    return editor.document.uri;
  }
  const files = await vscode.workspace.findFiles("**/*.{dtx,DTX}");
  const items = files.map((uri) => ({ label: vscode.workspace.asRelativePath(uri), uri }));
  items.sort((left, right) => left.label.localeCompare(right.label));
  return (await vscode.window.showQuickPick(items, { placeHolder: "Data file that is shown as tables", ignoreFocusOut: true }))?.uri;
}
