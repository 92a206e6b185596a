// Debug session: the process `val3 dap`. Its messages are converted here, so that code views can be debugged like
// files.

import { type ChildProcessWithoutNullStreams, spawn } from "node:child_process";
import type { DebugProtocol as Protocol } from "@vscode/debugprotocol";
import * as vscode from "vscode";
import { frame, MessageReader } from "./frames";
import type { SourceTranslator } from "./sources";
import { markArrays } from "./variables";

/** Milliseconds after the end of a session before the process is killed. */
const TIMEOUT = 2000;

export class Adapter extends vscode.Disposable implements vscode.DebugAdapter {
  private readonly messages = new vscode.EventEmitter<vscode.DebugProtocolMessage>();
  readonly onDidSendMessage = this.messages.event;
  private readonly process: ChildProcessWithoutNullStreams;
  /** Requests without a response. */
  private readonly open = new Map<number, Protocol.Request>();
  /** Keeps the messages to the process in order. */
  private turns: Promise<void> = Promise.resolve();
  private hasEnded = false;

  /** Starts `command` in `folder`, to which relative paths in the configuration refer. */
  constructor(private readonly command: string, folder: string | undefined, private readonly sources: SourceTranslator) {
    super(() => this.stop());
    this.process = spawn(command, ["dap"], { cwd: folder });
    const reader = new MessageReader((message) => this.receive(message as Protocol.ProtocolMessage));
    this.process.stdout.on("data", (bytes: Buffer) => this.attempt(() => reader.push(bytes)));
    this.process.stderr.on("data", (bytes: Buffer) => this.print(bytes.toString()));
    // A process that has ended does not read. Its end is reported below.
    this.process.stdin.on("error", () => undefined);
    this.process.on("error", (fault) => this.end(`${command} cannot be started: ${fault.message}`));
    this.process.on("close", (code) => this.end(`${command} dap has ended with ${code ?? "a signal"}.`));
  }

  handleMessage(message: vscode.DebugProtocolMessage): void {
    const request = message as Protocol.Request;
    if (this.hasEnded) {
      this.refuse(request, "The debugger has ended.");
      return;
    }
    this.open.set(request.seq, request);
    this.turns = this.turns.then(async () => {
      this.process.stdin.write(frame(await this.sources.toAdapter(request)));
    }).catch((fault: unknown) => this.refuse(request, String(fault)));
  }

  private stop(): void {
    this.process.stdin.end();
    if (this.process.pid === undefined || this.process.exitCode !== null) {
      return;
    }
    const kill = setTimeout(() => this.process.kill(), TIMEOUT);
    this.process.once("close", () => clearTimeout(kill));
  }

  private receive(message: Protocol.ProtocolMessage): void {
    if (message.type === "response") {
      this.open.delete((message as Protocol.Response).request_seq);
    }
    this.messages.fire(markArrays(this.sources.toClient(message)));
  }

  private attempt(work: () => void): void {
    try {
      work();
    } catch (fault) {
      this.end(`${this.command} dap: ${String(fault)}`);
    }
  }

  /** Ends the session, and fails all pending requests. */
  private end(reason: string): void {
    if (!this.hasEnded) {
      this.hasEnded = true;
      this.open.forEach((request) => this.refuse(request, reason));
      this.emit({ seq: 0, type: "event", event: "terminated" });
    }
  }

  private refuse({ seq, command }: Protocol.Request, message: string): void {
    this.open.delete(seq);
    this.emit({ seq: 0, type: "response", request_seq: seq, command, success: false, message });
  }

  private print(output: string): void {
    this.emit({ seq: 0, type: "event", event: "output", body: { category: "stderr", output } });
  }

  private emit(message: Protocol.ProtocolMessage & Record<string, unknown>): void {
    this.messages.fire(message);
  }
}
