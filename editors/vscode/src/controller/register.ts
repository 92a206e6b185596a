// The view "Controller" and its commands. They are registered only in a trusted folder, because the folder's state
// contains the address to which they connect.

import * as vscode from "vscode";
import type { Client } from "../client";
import { reason } from "../tree/changes";
import { openLocalFile, SHOW_CHANGES, showChanges } from "./changes";
import { compare } from "./compare";
import { ControllerDocuments } from "./documents";
import type { ControllerNode } from "./items";
import { Passwords } from "./passwords";
import type { Project } from "./projects";
import { pull, pullNew } from "./pull";
import { push } from "./push";
import { Transfers } from "./transfers";
import { ControllerView } from "./view";

/** `report` receives the errors of background work. */
export function registerController(client: Client, report: (fault: unknown) => void): vscode.Disposable[] {
  const transfers = new Transfers(client, new Passwords());
  const documents = new ControllerDocuments();
  const view = new ControllerView(report);
  const command = (id: string, action: (node: ControllerNode | undefined) => Promise<unknown>): vscode.Disposable =>
    vscode.commands.registerCommand(id, async (node?: ControllerNode) => {
      await action(node).catch((fault: unknown) => void vscode.window.showErrorMessage(reason(fault)));
    });
  const pullAndCompare = async (node: ControllerNode | undefined): Promise<void> => {
    const projects = await view.projects();
    const project = projects.length === 0 ? await pullNew(transfers) : await chosen(node, projects);
    if (project !== undefined && (projects.length === 0 || (await pull(project, transfers)))) {
      await compare(project, transfers, view);
    }
  };
  const pushAndCompare = async (node: ControllerNode | undefined, names: readonly string[]): Promise<void> => {
    const project = await chosen(node, await view.projects());
    if (project !== undefined && (await push(project, names, transfers))) {
      await compare(project, transfers, view);
    }
  };
  return [
    vscode.Disposable.from(transfers, documents, view),
    command("val3.controller.pull", pullAndCompare),
    // A button in the title of the view also receives the selected item.
    command("val3.controller.push", (node) => pushAndCompare(node, [])),
    command("val3.controller.pushApplication", async (node) => {
      await (node?.application === undefined ? undefined : pushAndCompare(node, [node.application]));
    }),
    command("val3.controller.compare", async (node) => {
      const project = await chosen(node, await view.projects());
      await (project && compare(project, transfers, view));
    }),
    command(SHOW_CHANGES, async (node) => node && showChanges(node, transfers, documents)),
    command("val3.controller.openFile", async (node) => node && openLocalFile(node)),
  ];
}

/**
 * Returns the project of the item, the only one, or the one that the user selects. The item may be older than the state of
 * its project.
 */
async function chosen(node: ControllerNode | undefined, projects: readonly Project[]): Promise<Project | undefined> {
  const ofNode = projects.find(({ folder }) => folder === node?.project.folder);
  if (ofNode !== undefined) {
    return ofNode;
  }
  if (projects.length === 0) {
    void vscode.window.showInformationMessage("No folder of the workspace has a controller yet. Pull its files first.");
  }
  const items = projects.map((project) => ({ label: project.address, description: project.serial, detail: project.folder, project }));
  return items.length < 2 ? projects[0] : (await vscode.window.showQuickPick(items, { placeHolder: "The controller" }))?.project;
}
