// The view "VAL 3": applications with their programs, data, libraries and types, as the server sees them.

import * as vscode from "vscode";
import { type Location, type Range, State } from "vscode-languageclient/node";
import type { Client } from "./client";

/** An element of the response to `val3/workspaceTree`, one for each `.pjx`. */
interface Project extends Record<Kind, Item[]> {
  name: string;
  uri: string;
}

interface Item {
  name: string;
  detail: string;
  location: Location;
}

type Kind = "programs" | "data" | "libraries" | "types";

/** The groups of a project, in this order, with their icons. */
const KINDS: [Kind, string, string][] = [
  ["programs", "Programs", "symbol-method"],
  ["data", "Data", "symbol-variable"],
  ["libraries", "Libraries", "library"],
  ["types", "Types", "symbol-structure"],
];

/** An item of the view. */
interface Node {
  label: string;
  item: vscode.TreeItem;
  children: Node[];
}

/** Milliseconds without a change after which the view is updated. */
const PAUSE = 300;

export class WorkspaceTree implements vscode.TreeDataProvider<Node>, vscode.Disposable {
  private readonly changes = new vscode.EventEmitter<void>();
  readonly onDidChangeTreeData = this.changes.event;
  private readonly subscription: vscode.Disposable;
  private pause: NodeJS.Timeout | undefined;
  private projects: Node[] = [];

  constructor(private readonly client: Client, private readonly output: vscode.LogOutputChannel) {
    this.subscription = client.onDidTellChange(() => {
      clearTimeout(this.pause);
      this.pause = setTimeout(() => this.refresh(), PAUSE);
    });
  }

  dispose(): void {
    clearTimeout(this.pause);
    this.subscription.dispose();
    this.changes.dispose();
  }

  refresh(): void {
    this.changes.fire();
  }

  async getChildren(parent?: Node): Promise<Node[]> {
    if (parent !== undefined) {
      return parent.children;
    }
    try {
      const isRunning = this.client.state === State.Running;
      const projects = isRunning ? await this.client.request<Project[]>("val3/workspaceTree") : [];
      this.projects = projects.map(projectNode).sort(byLabel);
    } catch (fault) {
      // The previous content is better than none.
      this.output.warn(`val3/workspaceTree: ${String(fault)}`);
    }
    return this.projects;
  }

  getTreeItem({ item }: Node): vscode.TreeItem {
    return item;
  }
}

function projectNode(project: Project): Node {
  const uri = vscode.Uri.parse(project.uri);
  const children = KINDS.flatMap((kind) => groupNode(project, kind));
  const item = collapsible(project.name, "package", "project", project.uri);
  item.description = vscode.workspace.asRelativePath(vscode.Uri.joinPath(uri, ".."));
  item.resourceUri = uri;
  return { label: project.name, item, children };
}

function groupNode(project: Project, [kind, label, icon]: (typeof KINDS)[number]): Node[] {
  const items = project[kind];
  if (items.length === 0) {
    return [];
  }
  const group = collapsible(label, "folder", "group", `${project.uri}#${kind}`);
  group.description = String(items.length);
  return [{ label, item: group, children: items.map((item) => itemNode(item, icon, kind)).sort(byLabel) }];
}

function itemNode({ name, detail, location }: Item, icon: string, kind: Kind): Node {
  const item = new vscode.TreeItem(name);
  item.iconPath = new vscode.ThemeIcon(icon);
  item.description = detail;
  item.contextValue = kind === "programs" ? "program" : kind;
  item.command = openCommand(kind, name, location);
  // "Open Code" of the context menu gets the item and uses its file and program.
  item.resourceUri = vscode.Uri.parse(location.uri);
  return { label: name, item, children: [] };
}

/** Items with the same `id` stay open when the view is filled again. */
function collapsible(label: string, icon: string, context: string, id: string): vscode.TreeItem {
  const item = new vscode.TreeItem(label, vscode.TreeItemCollapsibleState.Collapsed);
  item.id = id;
  item.iconPath = new vscode.ThemeIcon(icon);
  item.contextValue = context;
  return item;
}

function openCommand(kind: Kind, label: string, location: Location): vscode.Command {
  const uri = vscode.Uri.parse(location.uri);
  const asCode = vscode.workspace.getConfiguration("val3").get<boolean>("codeView.openByDefault", false);
  if (kind === "programs" && asCode) {
    return { command: "val3.openCode", title: "Open", arguments: [{ item: { label, resourceUri: uri } }] };
  }
  if (kind === "data" && vscode.workspace.getConfiguration("val3").get<boolean>("dataEditor.openByDefault", false)) {
    return { command: "val3.openData", title: "Open", arguments: [uri, label] };
  }
  return { command: "vscode.open", title: "Open", arguments: [uri, { selection: selection(location.range) }] };
}

function selection({ start, end }: Range): vscode.Range {
  return new vscode.Range(start.line, start.character, end.line, end.character);
}

function byLabel(left: Node, right: Node): number {
  return left.label.localeCompare(right.label);
}
