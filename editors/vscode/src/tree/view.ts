// The view "VAL 3": applications with their programs, data, libraries and types, as the server sees them.

import * as vscode from "vscode";
import { State } from "vscode-languageclient/node";
import type { Client } from "../client";
import { treeItem } from "./items";
import { TreeModel, type TreeNode } from "./nodes";
import type { Project } from "./protocol";

export const VIEW = "val3.workspace";

/** Milliseconds without a change after which the view is updated. */
const PAUSE = 300;
/** The key under which the filter is kept for the workspace. */
const FILTER = "tree.filter";
/** Is set while the view shows a part of the items. */
const IS_FILTERED = "val3.treeIsFiltered";

export class WorkspaceTree implements vscode.TreeDataProvider<TreeNode>, vscode.Disposable {
  private readonly changes = new vscode.EventEmitter<void>();
  readonly onDidChangeTreeData = this.changes.event;
  private readonly subscription: vscode.Disposable;
  private readonly view: vscode.TreeView<TreeNode>;
  private pause: NodeJS.Timeout | undefined;
  /** Something may have changed while nobody saw the view. */
  private isStale = false;
  private projects: Project[] | undefined;
  /** The last answer of the server, to notice that nothing has changed. */
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

  /** Asks the server again, and updates the view if its answer is another one. A hidden view waits until it is seen: the
   * answer about a cell with 10,000 points has 4 MB. */
  async refresh(): Promise<void> {
    this.isStale = !this.view.visible;
    if (!this.isStale && (await this.read())) {
      this.changes.fire();
    }
  }

  /** The text that names contain. The view shows everything if it is empty. */
  get filter(): string {
    return this.memory.get<string>(FILTER, "");
  }

  async setFilter(text: string): Promise<void> {
    await this.memory.update(FILTER, text);
    this.changes.fire();
  }

  /** The selected item. */
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
    // Nobody waits for it: until the items are there, the editor knows none for a command.
    void vscode.commands.executeCommand("setContext", IS_FILTERED, filter !== "");
  }

  /** Whether there is something else to show. */
  private async read(): Promise<boolean> {
    try {
      const isRunning = this.client.state === State.Running;
      const projects = isRunning ? await this.client.request<Project[]>("val3/workspaceTree") : [];
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
