// The view "VAL 3" and the commands on its items.

import * as vscode from "vscode";
import { State } from "vscode-languageclient/node";
import type { Client } from "../client";
import { newProgram } from "../commands/newProgram";
import { DEBUG, RUN } from "../debug/lenses";
import { rangeOf } from "../ranges";
import type { TreeProject } from "../serverRequests";
import { addReference } from "./additions";
import { findUses, reason, remove, rename } from "./changes";
import type { TreeNode } from "./nodes";
import { WorkspaceTree } from "./view";

/** Command of the data editor. */
const OPEN_DATA = "val3.openData";

type Action = (node: TreeNode) => Promise<unknown>;

export function registerTree(client: Client, memory: vscode.Memento, output: vscode.LogOutputChannel): Pick<vscode.Disposable, "dispose">[] {
  const tree = new WorkspaceTree(client, memory, output);
  const command = (name: string, action: Action): vscode.Disposable =>
    vscode.commands.registerCommand(`val3.tree.${name}`, async (argument?: unknown) => {
      // For a key binding, the argument is the focused item, if the editor provides it.
      const node = isNode(argument) ? argument : tree.selected;
      if (node === undefined) {
        // If the view was updated between the selection of an item and the command, no item is selected.
        void vscode.window.showInformationMessage("No item of the view VAL 3 is selected. Select it and choose the command again.");
        return;
      }
      await action(node).catch((fault: unknown) => void vscode.window.showErrorMessage(reason(fault)));
    });
  return [
    tree,
    vscode.commands.registerCommand("val3.refreshTree", () => tree.refresh()),
    vscode.commands.registerCommand("val3.filterTree", () => askForFilter(tree)),
    vscode.commands.registerCommand("val3.clearTreeFilter", () => tree.setFilter("")),
    client.onDidChangeState((state) => state === State.Running && void tree.refresh()),
    command("newProgram", ofProject((project) => newProgram(vscode.Uri.parse(project.uri)))),
    command("addLibrary", ofProject((project) => addReference(client, project, "library"))),
    command("addType", ofProject((project) => addReference(client, project, "type"))),
    command("run", (node) => start(RUN, node)),
    command("debug", (node) => start(DEBUG, node)),
    command("showRobot", ofProject(async (project) => vscode.commands.executeCommand("val3.showRobot", project.uri))),
    command("rename", ofNamed((node) => rename(client, node))),
    command("delete", ofNamed((node) => remove(client, node))),
    command("findUses", ofNamed((node) => findUses(client, node))),
    command("openCode", ofFile((uri, { label }) => vscode.commands.executeCommand("val3.openCode", { item: { label, resourceUri: uri } }))),
    command("openFile", ofFile((uri, { target }) => vscode.commands.executeCommand("vscode.open", uri, target && { selection: rangeOf(target.range) }))),
    command("openData", ofFile((uri, { label }) => vscode.commands.executeCommand(OPEN_DATA, uri, label))),
    command("reveal", ofFile((uri) => vscode.commands.executeCommand("revealInExplorer", uri))),
  ];
}

function isNode(argument: unknown): argument is TreeNode {
  return typeof argument === "object" && argument !== null && "context" in argument && "spoken" in argument;
}

/** Key bindings apply to every item; items without the necessary property remain unchanged. */
const ofNamed = (action: Action): Action => async (node) => node.item && action(node);

function ofProject(action: (project: TreeProject) => Promise<unknown>): Action {
  return async ({ project }) => project && action(project);
}

function ofFile(action: (uri: vscode.Uri, node: TreeNode) => Thenable<unknown>): Action {
  return async (node) => node.target && action(vscode.Uri.parse(node.target.uri), node);
}

async function start(command: string, { project, item }: TreeNode): Promise<void> {
  if (project !== undefined) {
    await vscode.commands.executeCommand(command, project.uri, item?.name);
  }
}

async function askForFilter(tree: WorkspaceTree): Promise<void> {
  const prompt = "A part of the names to show; nothing shows all";
  const text = await vscode.window.showInputBox({ prompt, value: tree.filter, placeHolder: "Name of a program, data, a library or a type" });
  if (text !== undefined) {
    await tree.setFilter(text.trim());
  }
}
