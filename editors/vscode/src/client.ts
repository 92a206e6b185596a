// Connection to `val3 lsp`.

import * as vscode from "vscode";
import {
  CloseAction, type CloseHandlerResult, ErrorAction, ErrorCodes, type ErrorHandler, LanguageClient, type LanguageClientOptions,
  type Location, type Middleware, type ReferenceParams, type RenameParams, ResponseError, State, type TextDocumentPositionParams,
  type WorkspaceEdit,
} from "vscode-languageclient/node";
import type { CodeFiles } from "./codeView/files";
import { codeViewMiddleware } from "./codeView/middleware";
import { SCHEME } from "./codeView/uris";
import { RENAME, SELECT } from "./commands/rename";
import { SHOW_REFERENCES } from "./commands/showReferences";
import { DEBUG, RUN } from "./debug/lenses";
import { CrashLimit, TOO_MANY } from "./crashLimit";
import { encodingMiddleware, withOpenFiles } from "./encoding/middleware";
import type { Findings } from "./findings";
import { findServer } from "./server";
import type { ServerRequests } from "./serverRequests";
import { DEBUG_TEST, RUN_TEST } from "./testing/commands";

/** Commands that the server may use in code lenses and code actions: commands/. */
const COMMANDS = [SHOW_REFERENCES, RENAME, SELECT];
/** Additional commands in a trusted folder, because they execute programs: debug/lenses.ts, testing/commands.ts. */
const EXECUTING = [RUN, DEBUG, RUN_TEST, DEBUG_TEST];
const LANGUAGES = ["val3", "val3-data", "val3-project"];

/** Files of user pages: a rename changes them, and the server uses their unsaved text. */
const PAGES = { scheme: "file", pattern: "**/interface/*.{bindings.json,html}" };

/** File with the things around the arm, which contains names of frames and tools. */
const CELL = { scheme: "file", pattern: "**/cell.toml" };

/** Suppresses notifications before the server runs, because `Client` reports these errors itself. */
class QuietClient extends LanguageClient {
  override error(message: string, data?: unknown, showNotification?: boolean | "force"): void {
    super.error(message, data, this.state === State.Running ? showNotification : false);
  }
}

/** Requests `val3/…`, and the requests of the protocol that views send. */
interface Requests extends ServerRequests {
  "textDocument/prepareRename": { params: TextDocumentPositionParams; result: unknown };
  "textDocument/references": { params: ReferenceParams; result: Location[] | null };
  "textDocument/rename": { params: RenameParams; result: WorkspaceEdit };
}

/** Arguments after the method: none for a request without parameters. */
type Params<Method extends keyof Requests> = Requests[Method]["params"] extends null ? [] : [params: Requests[Method]["params"]];

export class Client implements vscode.Disposable {
  private readonly states = new vscode.EventEmitter<State>();
  private readonly contents = new vscode.EventEmitter<void>();
  readonly onDidChangeState = this.states.event;
  /** Fires after the server was notified of a change in an editor or on the disk. */
  readonly onDidTellChange = this.contents.event;
  private running: LanguageClient | undefined;
  /** Current server process. */
  private serverProcess: ServerProcess | undefined;
  /** Serialises starts and stops. */
  private turns: Promise<void> = Promise.resolve();
  private readonly crashLimit = new CrashLimit();
  /** Command of the server, once it was found. */
  command: string | undefined;

  constructor(
    private readonly context: vscode.ExtensionContext,
    private readonly output: vscode.LogOutputChannel,
    private readonly views: CodeFiles,
    private readonly findings: Findings,
  ) {}

  /** Starts or restarts the server. Errors are shown to the user, not thrown. */
  async restart(): Promise<void> {
    this.crashLimit.reset();
    await this.startAnew();
  }

  async stop(): Promise<void> {
    await this.turn(() => this.halt());
  }

  /** Sends a request. Throws while no server runs. */
  async request<Method extends keyof Requests>(method: Method, ...[params]: Params<Method>): Promise<Requests[Method]["result"]> {
    if (this.running === undefined) {
      throw new Error("The server is not running.");
    }
    // An undefined parameter would be sent as null.
    return params === undefined ? this.running.sendRequest(method) : this.running.sendRequest(method, params);
  }

  /** Returns the URI that the server uses for a file. */
  addressOf(file: vscode.Uri): string {
    return this.running?.code2ProtocolConverter.asUri(file) ?? file.toString();
  }

  /** Converts an edit from the server, for files that are open in their own encodings. Throws while no server runs. */
  async workspaceEdit(edit: WorkspaceEdit): Promise<vscode.WorkspaceEdit> {
    if (this.running === undefined) {
      throw new Error("The server is not running.");
    }
    return withOpenFiles(await this.running.protocol2CodeConverter.asWorkspaceEdit(edit));
  }

  /** Applies an edit from the server, and returns whether that was possible. */
  async applyEdit(edit: WorkspaceEdit): Promise<boolean> {
    return vscode.workspace.applyEdit(await this.workspaceEdit(edit));
  }

  get state(): State {
    return this.running?.state ?? State.Stopped;
  }

  /** Name and version that the server reports. */
  get version(): string {
    return this.running?.initializeResult?.serverInfo?.version ?? "";
  }

  dispose(): void {
    this.states.dispose();
    this.contents.dispose();
  }

  private async startAnew(): Promise<void> {
    await this.turn(async () => {
      await this.halt();
      await this.begin();
    });
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
      this.output.error(found.fault);
      offer(found.fault, OPEN_SETTINGS);
      return;
    }
    this.command = found.command;
    const server = { command: found.command, args: ["lsp", ...settings.get<string[]>("server.arguments", [])] };
    const serverProcess = new ServerProcess();
    this.serverProcess = serverProcess;
    const running = new QuietClient("val3", "VAL 3", server, this.options(serverProcess));
    this.running = running;
    running.onDidChangeState(({ newState }) => {
      this.states.fire(newState);
      serverProcess.hasRun ||= newState === State.Running;
    });
    // Deferred until the client has handled the end of the connection.
    serverProcess.crash.catch(() => setTimeout(() => serverProcess.hasRun && this.reportCrash(serverProcess)));
    try {
      // If the server crashes during its start, the client would wait forever.
      await Promise.race([running.start(), serverProcess.crash]);
    } catch (fault) {
      if (serverProcess.hasRun && (serverProcess.hasCrashed || isGone(fault))) {
        // The crash was so early that the client regards the server as not started.
        this.reportCrash(serverProcess);
        return;
      }
      const reason = serverProcess.hasCrashed || isGone(fault) ? "it ended before it answered" : fault instanceof Error ? fault.message : String(fault);
      this.output.error(`${found.command}: ${reason}`);
      offer(`The VAL 3 server ${found.command} does not start: ${reason}.`, RESTART, SHOW_OUTPUT, OPEN_SETTINGS);
    }
  }

  /** Handles a crash of the running server, which is reported in several ways. */
  private reportCrash(serverProcess: ServerProcess): void {
    if (serverProcess.isReported) {
      return;
    }
    serverProcess.isReported = true;
    if (this.crashLimit.add(Date.now()) === "again") {
      this.output.warn("The server ended by itself and is started again.");
      offerCalmly("The VAL 3 server ended unexpectedly. It is started again.", SHOW_OUTPUT);
      void this.startAnew();
    } else {
      this.output.error("The server ended by itself again and again. It is not started any more.");
      void this.stop();
      offer(`The VAL 3 server ended unexpectedly ${TOO_MANY} times within three minutes and is not started any more. `
        + "Until it runs, nothing is checked or completed.", RESTART, SHOW_OUTPUT);
    }
  }

  private async halt(): Promise<void> {
    const running = this.running;
    this.running = undefined;
    this.serverProcess = undefined;
    try {
      await running?.dispose();
    } catch (fault) {
      // A server that never started or that hangs cannot be stopped. The next one starts nevertheless.
      this.output.warn(String(fault));
    }
  }

  private options(serverProcess: ServerProcess): LanguageClientOptions {
    const files = LANGUAGES.flatMap((language) => ["file", "untitled"].map((scheme) => ({ scheme, language })));
    return {
      documentSelector: [...files, PAGES, CELL, { scheme: SCHEME, language: "val3-code" }],
      initializationOptions: {
        ...vscode.workspace.getConfiguration("val3"),
        commands: [...COMMANDS, ...(vscode.workspace.isTrusted ? EXECUTING : [])],
      },
      synchronize: { configurationSection: "val3" },
      outputChannel: this.output,
      diagnosticCollectionProvider: this.findings,
      // `begin` reports the failure once.
      initializationFailedHandler: () => false,
      errorHandler: crashHandler(serverProcess),
      middleware: { ...codeViewMiddleware(this.views), ...encodingMiddleware, ...this.changeMiddleware(serverProcess) },
    };
  }

  private changeMiddleware(serverProcess: ServerProcess): Middleware {
    return {
      didChange: async (event, next) => {
        await next(event);
        this.contents.fire();
      },
      workspace: {
        didChangeConfiguration: async (sections, next) => {
          // Some settings start another server, which reads all settings, so the old server needs no notification.
          await this.turns;
          if (this.serverProcess === serverProcess && this.state === State.Running) {
            await next(sections);
          }
        },
        didChangeWatchedFile: async (event, next) => {
          await next(event);
          this.contents.fire();
        },
        willRenameFiles: async (event, next) => withOpenFiles(await next(event)),
      },
    };
  }
}

/** State of a server process. */
class ServerProcess {
  /** Whether the server has responded. */
  hasRun = false;
  /** Whether the server closed the connection without a request to do so. */
  hasCrashed = false;
  /** Whether the crash was reported to the user. */
  isReported = false;
  /** Rejects when the server crashes. */
  readonly crash: Promise<never>;
  private fail: (reason: Error) => void = () => undefined;

  constructor() {
    this.crash = new Promise((_, fail) => (this.fail = fail));
    // The rejection is handled only by callers that await it.
    this.crash.catch(() => undefined);
  }

  end(): void {
    this.hasCrashed = true;
    this.fail(new Error("The server closed the connection."));
  }
}

/** Disables the client's restarts and messages, because `Client` handles a crash. */
function crashHandler(serverProcess: ServerProcess): ErrorHandler {
  return {
    error: () => ({ action: ErrorAction.Continue, handled: true }),
    closed: (): CloseHandlerResult => {
      serverProcess.end();
      return { action: CloseAction.DoNotRestart, message: "The connection to the server was closed.", handled: true };
    },
  };
}

/** Whether the other end has closed the connection. */
function isGone(fault: unknown): boolean {
  const codes: number[] = [ErrorCodes.MessageWriteError, ErrorCodes.PendingResponseRejected, ErrorCodes.ConnectionInactive];
  return fault instanceof ResponseError && codes.includes(fault.code);
}

/** Command that is offered as a button of a message. */
interface Help extends vscode.MessageItem {
  command: string;
  argument?: string;
}

const OPEN_SETTINGS: Help = { title: "Open Settings", command: "workbench.action.openSettings", argument: "val3.server.path" };
const RESTART: Help = { title: "Restart", command: "val3.restartServer" };
const SHOW_OUTPUT: Help = { title: "Show Output", command: "val3.showOutput" };

/** Shows an error with commands that help. */
function offer(fault: string, ...helps: Help[]): void {
  void vscode.window.showErrorMessage(fault, ...helps).then(take);
}

/** Shows a warning about a problem that is already being solved. */
function offerCalmly(fault: string, ...helps: Help[]): void {
  void vscode.window.showWarningMessage(fault, ...helps).then(take);
}

async function take(help: Help | undefined): Promise<void> {
  if (help !== undefined) {
    await vscode.commands.executeCommand(help.command, help.argument);
  }
}
