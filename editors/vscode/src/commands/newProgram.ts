// "New Program": a file, and its entry in the project.

import * as vscode from "vscode";
import { nameFault } from "./names";

export function registerNewProgram(): vscode.Disposable[] {
  return [vscode.commands.registerCommand("val3.newProgram", newProgram)];
}

async function newProgram(): Promise<void> {
  const project = await chooseProject();
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

/** The project of the active file, else the one that the user picks. */
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
  const document = await vscode.workspace.openTextDocument(project);
  const isOld = document.getText().includes("ProjectNameSpace");
  const file = vscode.Uri.joinPath(project, "..", `${name}.pgx`);
  const contents = Buffer.from(isOld ? oldProgram(name) : program(name));
  await vscode.workspace.fs.writeFile(file, contents);
  const entry = entryEdit(document, name, isOld);
  if (entry !== undefined && !document.getText().includes(`"${name}.pgx"`)) {
    const edit = new vscode.WorkspaceEdit();
    edit.set(project, [entry]);
    await vscode.workspace.applyEdit(edit);
    await document.save();
  }
  await vscode.commands.executeCommand("vscode.open", file);
}

/** The entry in the list of programs, in front of the first that follows by name, else behind the last. */
function entryEdit(project: vscode.TextDocument, name: string, isOld: boolean): vscode.TextEdit | undefined {
  const text = project.getText();
  const eol = project.eol === vscode.EndOfLine.CRLF ? "\r\n" : "\n";
  const element = isOld ? `<program file="${name}.pgx" />` : `<Program file="${name}.pgx" />`;
  const entries = [...text.matchAll(/^[ \t]*<[Pp]rogram\s[^>]*?file="([^"]+)\.pgx"[^>]*>/gm)];
  const next = entries.find(([, other]) => (other ?? "").toLowerCase() > name.toLowerCase());
  const last = entries.at(-1);
  if (next !== undefined) {
    return vscode.TextEdit.insert(project.positionAt(next.index), `    ${element}${eol}`);
  } else if (last !== undefined) {
    return vscode.TextEdit.insert(project.positionAt(last.index + last[0].length), `${eol}    ${element}`);
  }
  return emptyListEdit(project, element, eol);
}

function emptyListEdit(project: vscode.TextDocument, element: string, eol: string): vscode.TextEdit | undefined {
  const list = /<(Programs|programSection)\s*(?:\/>|>\s*<\/\1>)/.exec(project.getText());
  if (list === null) {
    return undefined;
  }
  const range = new vscode.Range(project.positionAt(list.index), project.positionAt(list.index + list[0].length));
  return vscode.TextEdit.replace(range, `<${list[1]}>${eol}    ${element}${eol}  </${list[1]}>`);
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
