// The connection to `val3 lsp`.

import * as vscode from "vscode";
import { LanguageClient, type LanguageClientOptions, type Middleware, type ServerOptions, type State } from "vscode-languageclient/node";
import type { CodeFiles } from "./codeView/files";
import { codeViewMiddleware, showFindings } from "./codeView/middleware";
import { SCHEME } from "./codeView/uris";
import { findServer } from "./server";

const LANGUAGES = ["val3", "val3-data", "val3-project"];

export class Client implements vscode.Disposable {
  readonly output = vscode.window.createOutputChannel("VAL 3", { log: true });
  private readonly states = new vscode.EventEmitter<State>();
  readonly onDidChangeState = this.states.event;
  private running: LanguageClient | undefined;
  /** The command in use, once it was found. */
  command: string | undefined;

  constructor(private readonly context: vscode.ExtensionContext, private readonly views: CodeFiles) {}

  /** Finds and starts the server. A server that does not start is told to the user, not to the caller. */
  async start(): Promise<void> {
    this.command = await findServer(this.context);
    if (this.command === undefined) {
      return;
    }
    const running = new LanguageClient("val3", "VAL 3", serverOptions(this.command), this.options());
    this.running = running;
    running.onDidChangeState(({ newState }) => this.states.fire(newState));
    showFindings(running, this.views, this.context);
    try {
      await running.start();
    } catch (error) {
      this.output.error(`${this.command}: ${String(error)}`);
      void vscode.window.showErrorMessage(`The server ${this.command} does not start: ${String(error)}`);
    }
  }

  async stop(): Promise<void> {
    const running = this.running;
    this.running = undefined;
    if (running?.isRunning() === true) {
      await running.stop();
    }
    await running?.dispose();
  }

  async restart(): Promise<void> {
    await this.stop();
    await this.start();
  }

  /** Sends a request of our own. Fails while there is no server. */
  async request<Answer>(method: string, params: unknown = null): Promise<Answer> {
    if (this.running === undefined) {
      throw new Error("The server is not running.");
    }
    return this.running.sendRequest<Answer>(method, params);
  }

  get isRunning(): boolean {
    return this.running?.isRunning() === true;
  }

  dispose(): void {
    void this.stop();
    this.states.dispose();
    this.output.dispose();
  }

  private options(): LanguageClientOptions {
    const files = LANGUAGES.flatMap((language) => ["file", "untitled"].map((scheme) => ({ scheme, language })));
    const middleware: Middleware = codeViewMiddleware(this.views);
    return {
      documentSelector: [...files, { scheme: SCHEME, language: "val3-code" }],
      initializationOptions: vscode.workspace.getConfiguration("val3"),
      synchronize: { configurationSection: "val3" },
      outputChannel: this.output,
      middleware,
    };
  }
}

function serverOptions(command: string): ServerOptions {
  const more = vscode.workspace.getConfiguration("val3").get<string[]>("server.arguments", []);
  return { command, args: ["lsp", ...more] };
}
