// The connection to `val3 lsp`.

import * as vscode from "vscode";
import { LanguageClient, type LanguageClientOptions, type Middleware, State } from "vscode-languageclient/node";
import type { CodeFiles } from "./codeView/files";
import { codeViewMiddleware } from "./codeView/middleware";
import { SCHEME } from "./codeView/uris";
import { SHOW_REFERENCES } from "./commands/showReferences";
import type { Findings } from "./findings";
import { findServer } from "./server";

/** What the server may ask for where it offers it: see commands/showReferences.ts. */
const COMMANDS = [SHOW_REFERENCES];
const LANGUAGES = ["val3", "val3-data", "val3-project"];

export class Client implements vscode.Disposable {
  private readonly states = new vscode.EventEmitter<State>();
  private readonly contents = new vscode.EventEmitter<void>();
  readonly onDidChangeState = this.states.event;
  /** The server was told of a change, in an editor or on the disk. */
  readonly onDidTellChange = this.contents.event;
  private running: LanguageClient | undefined;
  /** Starts and stops come one after the other. */
  private turns: Promise<void> = Promise.resolve();
  /** The command in use, once it was found. */
  command: string | undefined;

  constructor(
    private readonly context: vscode.ExtensionContext,
    private readonly output: vscode.LogOutputChannel,
    private readonly views: CodeFiles,
    private readonly findings: Findings,
  ) {}

  /** Starts the server, anew when it runs. What goes wrong is told to the user, not to the caller. */
  async restart(): Promise<void> {
    await this.turn(async () => {
      await this.halt();
      await this.begin();
    });
  }

  async stop(): Promise<void> {
    await this.turn(() => this.halt());
  }

  /** Sends a request of our own. Fails while there is no server. */
  async request<Answer>(method: string, params: unknown = null): Promise<Answer> {
    if (this.running === undefined) {
      throw new Error("The server is not running.");
    }
    return this.running.sendRequest<Answer>(method, params);
  }

  get state(): State {
    return this.running?.state ?? State.Stopped;
  }

  /** The name and version that the server gives itself. */
  get version(): string {
    return this.running?.initializeResult?.serverInfo?.version ?? "";
  }

  dispose(): void {
    this.states.dispose();
    this.contents.dispose();
  }

  private async turn(work: () => Promise<void>): Promise<void> {
    this.turns = this.turns.then(work).catch((fault: unknown) => this.output.error(String(fault)));
    await this.turns;
  }

  private async begin(): Promise<void> {
    const settings = vscode.workspace.getConfiguration("val3");
    const configured = settings.get("server.path", "");
    const found = findServer({ configured, extension: this.context.extensionPath, path: process.env.PATH ?? "" });
    if ("fault" in found) {
      this.command = undefined;
      this.states.fire(State.Stopped);
      offer(found.fault, "Open Settings", "workbench.action.openSettings", "val3.server.path");
      return;
    }
    this.command = found.command;
    const server = { command: found.command, args: ["lsp", ...settings.get<string[]>("server.arguments", [])] };
    const running = new LanguageClient("val3", "VAL 3", server, this.options());
    this.running = running;
    running.onDidChangeState(({ newState }) => this.states.fire(newState));
    try {
      await running.start();
    } catch (fault) {
      this.output.error(`${found.command}: ${String(fault)}`);
      offer(`The server ${found.command} does not start: ${String(fault)}`, "Show Output", "val3.showOutput");
    }
  }

  private async halt(): Promise<void> {
    const running = this.running;
    this.running = undefined;
    // A server that died, or never started, has nothing to be told.
    await running?.dispose();
  }

  private options(): LanguageClientOptions {
    const files = LANGUAGES.flatMap((language) => ["file", "untitled"].map((scheme) => ({ scheme, language })));
    return {
      documentSelector: [...files, { scheme: SCHEME, language: "val3-code" }],
      initializationOptions: { ...vscode.workspace.getConfiguration("val3"), commands: COMMANDS },
      synchronize: { configurationSection: "val3" },
      outputChannel: this.output,
      diagnosticCollectionProvider: this.findings,
      // Told by `begin`, once.
      initializationFailedHandler: () => false,
      middleware: { ...codeViewMiddleware(this.views), ...this.changeMiddleware() },
    };
  }

  private changeMiddleware(): Middleware {
    return {
      didChange: async (event, next) => {
        await next(event);
        this.contents.fire();
      },
      workspace: {
        didChangeWatchedFile: async (event, next) => {
          await next(event);
          this.contents.fire();
        },
      },
    };
  }
}

/** Tells a fault and offers a command that helps. */
function offer(fault: string, title: string, command: string, ...arguments_: string[]): void {
  void vscode.window.showErrorMessage(fault, title).then((chosen) => {
    return chosen === title ? vscode.commands.executeCommand(command, ...arguments_) : undefined;
  });
}
