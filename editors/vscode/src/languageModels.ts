// Offers `val3 mcp` to the language models of the editor, in editors that support this (VS Code 1.101 and newer).

import * as vscode from "vscode";
import type { Client } from "./client";

/** Id of the provider in the manifest. */
export const PROVIDER = "val3.tools";

/** The part of the interface that is newer than the oldest supported editor. */
interface Registry {
  registerMcpServerDefinitionProvider?(
    id: string,
    provider: { provideMcpServerDefinitions(): Server[] },
  ): vscode.Disposable;
}

interface Server {
  cwd?: vscode.Uri;
}

interface NewerEditor {
  lm?: Registry;
  McpStdioServerDefinition?: new (label: string, command: string, args: string[]) => Server;
}

/** Registers one server for each folder of the workspace. Its tools read only, and never leave their folder. */
export function registerTools(client: Pick<Client, "command">): vscode.Disposable[] {
  const { lm, McpStdioServerDefinition: Definition } = vscode as unknown as NewerEditor;
  if (lm?.registerMcpServerDefinitionProvider === undefined || Definition === undefined) {
    return [];
  }
  const provideMcpServerDefinitions = (): Server[] => {
    const { command } = client;
    const folders = vscode.workspace.workspaceFolders ?? [];
    const local = folders.filter((folder) => folder.uri.scheme === "file");
    return command === undefined ? [] : local.map((folder) => {
      const label = local.length === 1 ? "VAL 3" : `VAL 3: ${folder.name}`;
      const server = new Definition(label, command, ["mcp", "--root", folder.uri.fsPath]);
      server.cwd = folder.uri;
      return server;
    });
  };
  return [lm.registerMcpServerDefinitionProvider(PROVIDER, { provideMcpServerDefinitions })];
}
