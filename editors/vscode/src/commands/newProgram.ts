// "New Program": creates a file, and its entry in the project.

import * as vscode from "vscode";
import { openDocument } from "../encoding/documents";
import { nameFault } from "./names";
import { entry, isOld } from "./projectEntry";

export function registerNewProgram(): vscode.Disposable[] {
  return [vscode.commands.registerCommand("val3.newProgram", () => newProgram())];
}

/** Prompts for the name. The project is `own`, the project of the active file, or one that the user selects. */
export async function newProgram(own?: vscode.Uri): Promise<void> {
  const project = own ?? (await chooseProject());
  if (project === undefined) {
    return;
  }
  const folder = vscode.Uri.joinPath(project, "..");
  const taken = new Set((await vscode.workspace.fs.readDirectory(folder)).map(([name]) => name.toLowerCase()));
  const name = await vscode.window.showInputBox({
    prompt: `The name of the program in ${vscode.workspace.asRelativePath(project)}`,
    validateInput: (name) => nameFault(name, (lower) => taken.has(`${lower}.pgx`)),
  });
  if (name !== undefined) {
    await create(project, name);
  }
}

/** Returns the project of the active file, or one that the user selects. */
async function chooseProject(): Promise<vscode.Uri | undefined> {
  const projects = await vscode.workspace.findFiles("**/*.pjx", undefined, 1000);
  const active = vscode.window.activeTextEditor?.document.uri;
  const own = projects.filter((uri) => active !== undefined && folderOf(uri) === folderOf(active));
  if (own.length === 1 || projects.length === 1) {
    return own[0] ?? projects[0];
  }
  const items = projects.map((uri) => ({ label: vscode.workspace.asRelativePath(uri), uri }));
  items.sort((left, right) => left.label.localeCompare(right.label));
  return (await vscode.window.showQuickPick(items, { placeHolder: "The application or library of the new program" }))?.uri;
}

function folderOf({ path }: vscode.Uri): string {
  return path.slice(0, path.lastIndexOf("/"));
}

async function create(project: vscode.Uri, name: string): Promise<void> {
  const document = await openDocument(project);
  const text = document.getText();
  const file = vscode.Uri.joinPath(project, "..", `${name}.pgx`);
  await vscode.workspace.fs.writeFile(file, Buffer.from(isOld(text) ? oldProgram(name) : program(name)));
  const change = entry(text, name);
  if (change !== undefined) {
    const edit = new vscode.WorkspaceEdit();
    const range = new vscode.Range(document.positionAt(change.start), document.positionAt(change.end));
    edit.replace(project, range, change.text);
    await vscode.workspace.applyEdit(edit);
    await document.save();
  }
  await vscode.commands.executeCommand("vscode.open", file);
}

function program(name: string): string {
  return `\ufeff<?xml version="1.0" encoding="utf-8"?>
<Programs xmlns:xsi="http://www.w3.org/2001/XMLSchema-instance" xmlns="http://www.staubli.com/robotics/VAL3/Program/2">
  <Program name="${name}">
    <Code><![CDATA[begin
  // ${name}
end]]></Code>
  </Program>
</Programs>
`;
}

function oldProgram(name: string): string {
  return `<?xml version="1.0" encoding="utf-8" ?>
<programList xmlns="ProgramNameSpace" >
  <program name="${name}" public="false" >
    <description></description>
    <paramSection></paramSection>
    <localSection></localSection>
    <source><code>begin
  // ${name}
end
</code></source>
  </program>
</programList>
`;
}
