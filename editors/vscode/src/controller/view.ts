// The view "Controller": the controllers of the workspace, their applications, and the files that differ.

import * as vscode from "vscode";
import { treeItem } from "../tree/items";
import type { Comparison } from "./answers";
import { SHOW_CHANGES } from "./changes";
import { type Compared, type ControllerNode, projectNode } from "./items";
import { findProjects, type Project } from "./projects";

export const VIEW = "val3.controller";

export class ControllerView implements vscode.TreeDataProvider<ControllerNode>, vscode.Disposable {
  private readonly changes = new vscode.EventEmitter<void>();
  readonly onDidChangeTreeData = this.changes.event;
  private readonly view: vscode.TreeView<ControllerNode>;
  private readonly subscription: vscode.Disposable;
  /** Last comparisons, by project folder. */
  private readonly compared = new Map<string, Compared>();

  /** `report` receives the errors of background work. */
  constructor(private readonly report: (fault: unknown) => void) {
    this.view = vscode.window.createTreeView(VIEW, { treeDataProvider: this, showCollapseAll: true });
    // The state of a project can change in a terminal. Reading it needs no connection.
    this.subscription = this.view.onDidChangeVisibility(({ visible }) => visible && this.changes.fire());
  }

  dispose(): void {
    vscode.Disposable.from(this.subscription, this.view, this.changes).dispose();
  }

  /** Returns the controllers of the workspace. */
  async projects(): Promise<Project[]> {
    return findProjects(this.report);
  }

  /** Shows a comparison; without one, the project as not compared. */
  show({ folder }: Project, comparison?: Comparison): void {
    if (comparison === undefined) {
      this.compared.delete(folder);
    } else {
      const time = new Date().toLocaleTimeString(undefined, { hour: "2-digit", minute: "2-digit", hour12: false });
      this.compared.set(folder, { ...comparison, time });
    }
    this.changes.fire();
  }

  async getChildren(parent?: ControllerNode): Promise<ControllerNode[]> {
    if (parent !== undefined) {
      return parent.children?.() ?? [];
    }
    const projects = await this.projects();
    return projects.map((project) => projectNode(project, vscode.workspace.asRelativePath(project.folder), this.compared.get(project.folder)));
  }

  getTreeItem(node: ControllerNode): vscode.TreeItem {
    const item = treeItem(node);
    if (node.file !== undefined) {
      item.command = { command: SHOW_CHANGES, title: "Show Changes", arguments: [node] };
    }
    return item;
  }
}
