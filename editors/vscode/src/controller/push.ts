// "Push": shows what will change on the controller, and uploads it after a confirmation.

import * as vscode from "vscode";
import { reason } from "../tree/changes";
import { parsePlan } from "./answers";
import { confirmation } from "./confirmation";
import { notesOf } from "./messages";
import type { Project } from "./projects";
import type { Transfers } from "./transfers";

const PUSH = "Push";
const UNLOADED = "Unloaded: Push";
const UNSURE = "Not Sure: Check the Log";

/** Pushes all applications, or those with these names. Returns whether the controller was changed. */
export async function push(project: Project, names: readonly string[], transfers: Transfers): Promise<boolean> {
  const plan = await transfers.run({
    ...project,
    title: `Checking, and comparing with ${project.address}`,
    subcommand: "push",
    words: ["--dry-run", "--format", "json", ...names],
  });
  if (plan?.code !== 0) {
    await (plan && transfers.showFailure(plan));
    return false;
  }
  const { changes } = parsePlan(plan.output);
  if (changes.length === 0) {
    void vscode.window.showInformationMessage("There is nothing to push: the controller has the files of this folder.");
    return false;
  }
  const { message, detail, applications } = confirmation(project, changes, notesOf(plan.errors));
  const buttons = applications.length === 0 ? [PUSH] : [UNLOADED, UNSURE];
  const choice = await vscode.window.showWarningMessage(message, { modal: true, detail }, ...buttons);
  if (choice === undefined) {
    return false;
  }
  const pushed = await transfers.run({
    ...project,
    title: `Pushing to ${project.address}`,
    subcommand: "push",
    words: [...(choice === UNLOADED ? ["--unloaded"] : []), ...names],
    showsOutput: true,
  });
  if (pushed?.code !== 0) {
    await (pushed && transfers.showFailure(pushed));
    return false;
  }
  const lines = pushed.errors.trimEnd().split("\n").slice(1);
  void vscode.window.showInformationMessage(lines.map(reason).join(" "));
  return true;
}
