// The view "VAL 3": applications with their programs, data, libraries and types, as the server sees them.

import * as vscode from "vscode";
import type { Client } from "./client";

/** The server's own request; docs/src/editors.md describes it. */
const REQUEST = "val3/workspaceTree";

/** An item of the answer. */
interface TreeItem {
  label: string;
  kind: "application" | "library" | "type" | "folder" | "program" | "data" | "alias";
  detail?: string;
  uri?: string;
  range?: { start: { line: number; character: number }; end: { line: number; character: number } };
  children?: TreeItem[];
}

const ICONS: Record<TreeItem["kind"], string> = {
  application: "package",
  library: "library",
  type: "symbol-structure",
  folder: "folder",
  program: "symbol-method",
  data: "symbol-variable",
  alias: "references",
};

export class WorkspaceTree implements vscode.TreeDataProvider<TreeItem> {
  private readonly changes = new vscode.EventEmitter<void>();
  readonly onDidChangeTreeData = this.changes.event;

  constructor(private readonly client: Client) {
    vscode.workspace.onDidSaveTextDocument(({ languageId }) => languageId.startsWith("val3") && this.refresh());
    const files = vscode.workspace.createFileSystemWatcher("**/*.{pjx,pgx,dtx}", false, true, false);
    files.onDidCreate(() => this.refresh());
    files.onDidDelete(() => this.refresh());
  }

  refresh(): void {
    this.changes.fire();
  }

  async getChildren(parent?: TreeItem): Promise<TreeItem[]> {
    if (parent !== undefined) {
      return parent.children ?? [];
    }
    return this.client.can("workspaceTree") ? this.client.request<TreeItem[]>(REQUEST, {}) : [];
  }

  getTreeItem({ label, kind, detail, uri, range, children }: TreeItem): vscode.TreeItem {
    const collapsed = vscode.TreeItemCollapsibleState;
    const item = new vscode.TreeItem(label, (children?.length ?? 0) > 0 ? collapsed.Collapsed : collapsed.None);
    item.iconPath = new vscode.ThemeIcon(ICONS[kind]);
    item.contextValue = kind;
    item.description = detail;
    if (uri !== undefined) {
      item.command = openCommand(kind, vscode.Uri.parse(uri), range);
    }
    return item;
  }
}

function openCommand(kind: TreeItem["kind"], uri: vscode.Uri, range: TreeItem["range"]): vscode.Command {
  const asCode = vscode.workspace.getConfiguration("val3").get<boolean>("codeView.openByDefault", false);
  if (kind === "program" && asCode) {
    return { command: "val3.openCode", title: "Open", arguments: [uri] };
  }
  const selection = range && new vscode.Range(range.start.line, range.start.character, range.end.line, range.end.character);
  return { command: "vscode.open", title: "Open", arguments: [uri, { selection }] };
}
