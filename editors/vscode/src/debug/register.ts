// The debugger in VS Code.

import * as vscode from "vscode";
import type { Client } from "../client";
import type { CodeFiles } from "../codeView/files";
import { Adapter } from "./adapter";
import { Configurations, TYPE } from "./configurations";
import { registerLenses } from "./lenses";
import { SourceTranslator } from "./sources";
import { DebugViews } from "./views";

export function registerDebugging(client: Client, files: CodeFiles): vscode.Disposable[] {
  const configurations = new Configurations(client);
  const { Initial, Dynamic } = vscode.DebugConfigurationProviderTriggerKind;
  const views = new DebugViews(files);
  return [
    vscode.debug.registerDebugConfigurationProvider(TYPE, configurations, Initial),
    vscode.debug.registerDebugConfigurationProvider(TYPE, configurations, Dynamic),
    vscode.debug.registerDebugAdapterDescriptorFactory(TYPE, {
      createDebugAdapterDescriptor: ({ workspaceFolder }) => {
        if (client.command === undefined) {
          throw new Error("The command val3 was not found. Install it, or name it in the setting val3.server.path.");
        }
        const adapter = new Adapter(client.command, workspaceFolder?.uri.fsPath, new SourceTranslator(views));
        return new vscode.DebugAdapterInlineImplementation(adapter);
      },
    }),
    ...registerLenses(),
  ];
}
