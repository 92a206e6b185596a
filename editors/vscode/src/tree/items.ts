// Converts nodes to items of VS Code.

import * as vscode from "vscode";
import type { Location } from "vscode-languageclient/node";
import { rangeOf } from "../ranges";
import type { ItemContent } from "./nodes";

export function treeItem(node: ItemContent): vscode.TreeItem {
  const { None, Collapsed, Expanded } = vscode.TreeItemCollapsibleState;
  const item = new vscode.TreeItem(node.label, node.children === undefined ? None : node.isOpen ? Expanded : Collapsed);
  item.id = node.id;
  item.iconPath = new vscode.ThemeIcon(node.icon.id, node.icon.color === undefined ? undefined : new vscode.ThemeColor(node.icon.color));
  item.description = node.description;
  item.tooltip = node.tooltip;
  item.accessibilityInformation = { label: node.spoken };
  item.contextValue = node.context.join(" ");
  const { target } = node;
  if (target !== undefined) {
    // A click on an item that contains others opens it in the view, as in the explorer.
    item.command = node.children === undefined ? openCommand(node, target) : undefined;
    item.resourceUri = node.context.includes("data") ? undefined : vscode.Uri.parse(target.uri);
  }
  return item;
}

function openCommand({ context, label }: ItemContent, { uri, range }: Location): vscode.Command {
  const resourceUri = vscode.Uri.parse(uri);
  const asCode = vscode.workspace.getConfiguration("val3").get<boolean>("codeView.openByDefault", false);
  if (context.includes("program") && asCode) {
    return { command: "val3.openCode", title: "Open", arguments: [{ item: { label, resourceUri } }] };
  }
  if (context.includes("data") && vscode.workspace.getConfiguration("val3").get<boolean>("dataEditor.openByDefault", false)) {
    return { command: "val3.openData", title: "Open", arguments: [resourceUri, label] };
  }
  return { command: "vscode.open", title: "Open", arguments: [resourceUri, { selection: rangeOf(range) }] };
}
