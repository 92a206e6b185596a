// The view "VAL 3": applications with their programs, data, libraries and types, as the server lists them.

import * as vscode from "vscode";
import { State } from "vscode-languageclient/node";
import type { Client } from "../client";
import type { TreeProject } from "../serverRequests";
import { treeItem } from "./items";
import { TreeModel, type TreeNode } from "./nodes";

export const VIEW = "val3.workspace";

/** Milliseconds without a change after which the view is updated. */
const PAUSE = 300;
/** Key under which the filter is stored for the workspace. */
const FILTER = "tree.filter";
/** Context key: whether the view shows only a part of the items. */
const IS_FILTERED = "val3.treeIsFiltered";

export class WorkspaceTree implements vscode.TreeDataProvider<TreeNode>, vscode.Disposable {
  private readonly changes = new vscode.EventEmitter<void>();
  readonly onDidChangeTreeData = this.changes.event;
  private readonly subscription: vscode.Disposable;
  private readonly view: vscode.TreeView<TreeNode>;
  private pause: NodeJS.Timeout | undefined;
  /** Whether something may have changed while the view was hidden. */
  private isStale = false;
  private projects: readonly TreeProject[] | undefined;
  /** Last response from the server, to detect that nothing has changed. */
  private answer = "";

  constructor(private readonly client: Client, private readonly memory: vscode.Memento, private readonly output: vscode.LogOutputChannel) {
    this.view = vscode.window.createTreeView(VIEW, { treeDataProvider: this, showCollapseAll: true });
    this.subscription = vscode.Disposable.from(
      client.onDidTellChange(() => {
        clearTimeout(this.pause);
        this.pause = setTimeout(() => void this.refresh(), PAUSE);
      }),
      this.view.onDidChangeVisibility(({ visible }) => visible && this.isStale && void this.refresh()),
    );
  }

  dispose(): void {
    clearTimeout(this.pause);
    vscode.Disposable.from(this.subscription, this.view, this.changes).dispose();
  }

  /**
   * Requests the tree, and updates the view if the response differs. A hidden view is marked stale and refreshed when
   * it becomes visible, because the response for a cell with 10,000 points has 4 MB.
   */
  async refresh(): Promise<void> {
    this.isStale = !this.view.visible;
    if (!this.isStale && (await this.read())) {
      this.changes.fire();
    }
  }

  /** Returns the text that shown names contain. If it is empty, the view shows everything. */
  get filter(): string {
    return this.memory.get<string>(FILTER, "");
  }

  async setFilter(text: string): Promise<void> {
    await this.memory.update(FILTER, text);
    this.changes.fire();
  }

  /** Returns the selected item. */
  get selected(): TreeNode | undefined {
    return this.view.selection[0];
  }

  async getChildren(parent?: TreeNode): Promise<TreeNode[]> {
    if (parent !== undefined) {
      return parent.children?.() ?? [];
    }
    if (this.projects === undefined) {
      await this.read();
    }
    const model = new TreeModel(this.projects ?? [], this.filter, folderOf);
    this.showFilter(model.count);
    return model.roots();
  }

  getTreeItem(node: TreeNode): vscode.TreeItem {
    return treeItem(node);
  }

  private showFilter(count: number): void {
    const { filter } = this;
    const found = count === 0 ? "no name contains it" : count === 1 ? "1 name" : `${count} names`;
    this.view.message = filter === "" || this.projects === undefined ? undefined : `Filter “${filter}”: ${found}`;
    // Not awaited, because this would delay the items, and until they are shown, commands have no item.
    void vscode.commands.executeCommand("setContext", IS_FILTERED, filter !== "");
  }

  /** Requests the projects, and returns whether they have changed. */
  private async read(): Promise<boolean> {
    try {
      const isRunning = this.client.state === State.Running;
      const projects = isRunning ? await this.client.request("val3/workspaceTree") : [];
      const answer = JSON.stringify(projects);
      const isNew = answer !== this.answer || this.projects === undefined;
      this.projects = projects;
      this.answer = answer;
      return isNew;
    } catch (fault) {
      // The previous content is better than none.
      this.output.warn(`val3/workspaceTree: ${String(fault)}`);
      return false;
    }
  }
}

function folderOf(uri: string): string {
  return vscode.workspace.asRelativePath(vscode.Uri.joinPath(vscode.Uri.parse(uri), ".."));
}
