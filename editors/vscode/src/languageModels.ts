// Offers `val3 mcp` to the language models of the editor, in editors that support this (VS Code 1.101 and newer).

import * as vscode from "vscode";
import type { Client } from "./client";

/** Id of the provider in the manifest. */
export const PROVIDER = "val3.tools";

/** First version of VS Code 1 whose extensions may use the interface. 1.100 has the function, and rejects its call. */
const FIRST_MINOR = 101;

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
  version: string;
  lm?: Registry;
  McpStdioServerDefinition?: new (label: string, command: string, args: string[]) => Server;
}

/** Registers one server for each folder of the workspace. Its tools only read, and only within their folder. */
export function registerTools(client: Pick<Client, "command">): vscode.Disposable[] {
  const { version, lm, McpStdioServerDefinition: Definition } = vscode as unknown as NewerEditor;
  if (!isSupported(version) || lm?.registerMcpServerDefinitionProvider === undefined || Definition === undefined) {
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

function isSupported(version: string): boolean {
  const [major = 0, minor = 0] = version.split(".").map(Number);
  return major > 1 || (major === 1 && minor >= FIRST_MINOR);
}
