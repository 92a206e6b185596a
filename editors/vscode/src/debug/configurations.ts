// Launch configurations for the workspace's applications, and defaults for omitted keys.

import * as vscode from "vscode";
import type { Client } from "../client";
import { type Application, applications, pickApplication, START } from "./applications";

export const TYPE = "val3";

export class Configurations implements vscode.DebugConfigurationProvider {
  constructor(private readonly client: Client) {}

  async provideDebugConfigurations(folder: vscode.WorkspaceFolder | undefined): Promise<vscode.DebugConfiguration[]> {
    const found = await applications(this.client);
    return found.map(({ name, folder: path }) => launch(name, withVariable(path, folder)));
  }

  async resolveDebugConfiguration(
    folder: vscode.WorkspaceFolder | undefined,
    configuration: vscode.DebugConfiguration,
  ): Promise<vscode.DebugConfiguration | undefined> {
    // Without a launch.json the configuration is empty.
    const isEmpty = Object.keys(configuration).every((key) => key === "noDebug");
    if (isEmpty) {
      const application = await pickApplication(this.client);
      return application && { ...ofApplication(application), ...configuration };
    } else if (configuration.request === "attach") {
      return withAddress(configuration);
    } else if (typeof configuration.program === "string" && configuration.program.trim() !== "") {
      return withStopOnExit(configuration);
    }
    const application = await pickApplication(this.client);
    return application && { ...withStopOnExit(configuration), program: withVariable(application.folder, folder) };
  }
}

/** Returns the configuration for an application: the user's configuration if there is one, otherwise the default. */
export function ofApplication({ name, folder }: Application, startProgram = START): vscode.DebugConfiguration {
  const inFolder = vscode.workspace.getWorkspaceFolder(folder);
  const own = vscode.workspace.getConfiguration("launch", inFolder).get<vscode.DebugConfiguration[]>("configurations", []);
  const isOwn = (configuration: vscode.DebugConfiguration): boolean =>
    configuration.type === TYPE && configuration.request === "launch"
    && (configuration.startProgram ?? START) === startProgram
    && isFolder(configuration.program, folder, inFolder);
  const fallback = launch(name, folder.fsPath);
  const isStart = startProgram === START;
  return own.find(isOwn) ?? (isStart ? fallback : { ...fallback, name: `${name}: ${startProgram}()`, startProgram });
}

function launch(name: string, program: string): vscode.DebugConfiguration {
  return { type: TYPE, request: "launch", name, program, time: "real", stopOnExit: true };
}

/** Sets `stopOnExit` by default, so that a run stops before its end. Tests do not stop, because they end with their result. */
function withStopOnExit(configuration: vscode.DebugConfiguration): vscode.DebugConfiguration {
  return configuration.test === undefined ? { stopOnExit: true, ...configuration } : configuration;
}

function isFolder(program: unknown, folder: vscode.Uri, inFolder: vscode.WorkspaceFolder | undefined): boolean {
  const spelled = [folder.fsPath, withVariable(folder, inFolder), vscode.workspace.asRelativePath(folder, false)];
  return typeof program === "string" && spelled.includes(program.replace(/[/\\]+$/, ""));
}

/** Returns a path as users write it in a launch.json. */
function withVariable(path: vscode.Uri, folder: vscode.WorkspaceFolder | undefined): string {
  const prefix = folder === undefined ? undefined : `${folder.uri.path}/`;
  const isInside = prefix !== undefined && path.path.startsWith(prefix);
  return isInside ? `\${workspaceFolder}/${path.path.slice(prefix.length)}` : path.path === folder?.uri.path ? "${workspaceFolder}" : path.fsPath;
}

/** Prompts for the port and the secret of a run, unless the configuration contains them. */
async function withAddress(configuration: vscode.DebugConfiguration): Promise<vscode.DebugConfiguration | undefined> {
  const port = await portOf(configuration);
  const secret = port === undefined ? undefined : await secretOf(configuration, port);
  return secret === undefined ? undefined : { ...configuration, port: Number(port), secret };
}

async function portOf(configuration: vscode.DebugConfiguration): Promise<string | undefined> {
  const port = String(configuration.port);
  return isPort(port) ? port : vscode.window.showInputBox({
    prompt: "The port of the run, from val3 run --debug-port PORT",
    validateInput: (text) => (isPort(text) ? undefined : "A port is a number from 1 to 65535."),
  });
}

/** Returns the secret, which may contain variables that VS Code replaces later. */
async function secretOf(configuration: vscode.DebugConfiguration, port: string): Promise<string | undefined> {
  const secret: unknown = configuration.secret;
  if (typeof secret === "string" && secret !== "") {
    return secret;
  }
  const answer = await vscode.window.showInputBox({
    prompt: `The secret that val3 run has printed with the port ${port}`,
    validateInput: (text) => (text.trim() === "" ? "The secret follows the port in the first line of the run." : undefined),
  });
  return answer?.trim();
}

function isPort(text: string): boolean {
  return /^\d{1,5}$/.test(text) && Number(text) >= 1 && Number(text) <= 65535;
}
