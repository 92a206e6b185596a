// "Compare": lists the files that differ.

import * as vscode from "vscode";
import { parseComparison } from "./answers";
import { notesOf } from "./messages";
import type { Project } from "./projects";
import type { Transfers } from "./transfers";
import type { ControllerView } from "./view";

/** Exit codes with a result: no difference, or differences. */
const WITH_RESULTS: (number | null)[] = [0, 1];

export async function compare(project: Project, transfers: Transfers, view: ControllerView): Promise<void> {
  const finished = await transfers.run({
    ...project,
    title: `Comparing with ${project.address}`,
    subcommand: "status",
    words: ["--format", "json"],
  });
  if (finished === undefined) {
    return;
  }
  if (!WITH_RESULTS.includes(finished.code)) {
    await transfers.showFailure(finished);
    return;
  }
  view.show(project, parseComparison(finished.output));
  const notes = notesOf(finished.errors);
  if (notes.length > 0) {
    void vscode.window.showWarningMessage(notes.join(" "));
  }
}
