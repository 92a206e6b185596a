// The debugged run: its state, and the requests and events of `val3 dap` beyond the protocol, which
// docs/src/debugging.md describes.

import type { DebugProtocol as Protocol } from "@vscode/debugprotocol";
import * as vscode from "vscode";
import { TYPE } from "./configurations";
import type * as requests from "./requests";
import type { Message } from "./view/wire";

export type Source = requests.CodeLine;
export type Sample = requests.ArmSample;
export type Move = requests.QueuedMove;
export type Signal = requests.Signal;
export type UserPage = requests.ShownUserPage;
export type MotionMode = requests.MotionModeName;

/** Requests `val3/…`, and the requests of the protocol that views send. */
interface Requests extends requests.DebugRequests {
  threads: { arguments: object; body: Protocol.ThreadsResponse["body"] };
}
type Command = keyof Requests;
type Arguments<Name extends Command> = Requests[Name]["arguments"];
type Body<Name extends Command> = Requests[Name]["body"];

/** Requests after which the application runs. */
const RESUMING = new Set(["continue", "next", "stepIn", "stepOut", "val3/motionStep"]);
/** Seconds between two samples of the arm. */
const SAMPLING = 0.1;
/** Milliseconds between two updates of the views while the application runs. */
const PAUSE = 250;
/** Milliseconds after which a running application is polled, even if it has reported nothing. */
const POLL = 1000;

export class DebuggedRun implements vscode.Disposable {
  private readonly changes = new vscode.EventEmitter<void>();
  private readonly samples = new vscode.EventEmitter<Sample | undefined>();
  private readonly pages = new vscode.EventEmitter<UserPage | undefined>();
  private readonly views = new vscode.EventEmitter<Message[]>();
  private readonly sessions = new vscode.EventEmitter<void>();
  private readonly stops = new vscode.EventEmitter<void>();
  private readonly resumptions = new vscode.EventEmitter<void>();
  /** Fires when something may have changed, or the active session has changed. */
  readonly onDidChange = this.changes.event;
  /** Fires when the arm has moved; with `undefined` if no session is active. */
  readonly onDidMove = this.samples.event;
  /** Fires when the user page has changed; with `undefined` if no session is active. */
  readonly onDidChangePage = this.pages.event;
  /** Fires for messages to the page that shows the robot, while it is visible. */
  readonly onDidView = this.views.event;
  /** Fires when the active session has changed, or accepts requests from now on. */
  readonly onDidChangeSession = this.sessions.event;
  /** Fires when the application of the active session has stopped, also at another moment, or was changed there. */
  readonly onDidStop = this.stops.event;
  /** Fires when the application of the active session continues. */
  readonly onDidResume = this.resumptions.event;
  private readonly subscription: vscode.Disposable;
  private readonly poll: NodeJS.Timeout;
  private pause: NodeJS.Timeout | undefined;
  /** Sessions that accept requests, and whether their application runs. */
  private readonly running = new Map<string, boolean>();

  constructor(private readonly report: (fault: unknown) => void) {
    this.subscription = vscode.Disposable.from(
      vscode.debug.registerDebugAdapterTrackerFactory(TYPE, {
        createDebugAdapterTracker: (session) => ({ onDidSendMessage: (message: Protocol.ProtocolMessage) => this.see(session, message) }),
      }),
      vscode.debug.onDidReceiveDebugSessionCustomEvent(({ session, event, body }) => session === this.session && this.take(event, body)),
      vscode.debug.onDidChangeActiveDebugSession(() => {
        this.sessions.fire();
        void this.show().catch(report);
      }),
      vscode.debug.onDidTerminateDebugSession(({ id }) => {
        this.running.delete(id);
        this.sessions.fire();
        void this.show().catch(report);
      }),
    );
    this.poll = setInterval(() => this.isRunning && this.changes.fire(), POLL);
  }

  dispose(): void {
    clearInterval(this.poll);
    clearTimeout(this.pause);
    vscode.Disposable.from(this.subscription, this.changes, this.samples, this.pages, this.views, this.sessions, this.stops, this.resumptions).dispose();
  }

  /** Returns the active session, if it is a VAL 3 session and accepts requests. */
  get session(): vscode.DebugSession | undefined {
    const active = vscode.debug.activeDebugSession;
    return active?.type === TYPE && this.running.has(active.id) ? active : undefined;
  }

  private get isRunning(): boolean {
    return this.running.get(this.session?.id ?? "") === true;
  }

  /** Sends a request to the active session. `undefined` if there is no session, or if it ends meanwhile. */
  async request<Name extends Command>(command: Name, args: Arguments<Name>): Promise<Body<Name> | undefined> {
    const { session } = this;
    try {
      return (await session?.customRequest(command, args)) as Body<Name> | undefined;
    } catch (fault) {
      if (session === this.session) {
        throw fault;
      }
      return undefined;
    }
  }

  /** Changes something in the run. Errors are shown to the user. */
  async change<Name extends Command>(command: Name, args: Arguments<Name>): Promise<boolean> {
    try {
      await this.request(command, args);
      this.changes.fire();
      return true;
    } catch (fault) {
      void vscode.window.showErrorMessage(fault instanceof Error ? fault.message : String(fault));
      return false;
    }
  }

  private see(session: vscode.DebugSession, message: Protocol.ProtocolMessage): void {
    if (message.type === "response") {
      this.seeResponse(session, message as Protocol.Response);
      return;
    } else if (message.type !== "event" || !this.running.has(session.id)) {
      return;
    }
    const { event } = message as Protocol.Event;
    if (event === "stopped") {
      this.running.set(session.id, false);
    }
    if (event === "stopped" || event === "invalidated") {
      if (session === this.session && !this.isRunning) {
        this.stops.fire();
      }
      this.show().catch(this.report);
    } else if (event === "thread") {
      this.changeSoon();
    }
  }

  private seeResponse(session: vscode.DebugSession, { command, success }: Protocol.Response): void {
    if (command === "configurationDone" && success) {
      this.begin(session).catch(this.report);
    } else if (RESUMING.has(command) && success) {
      this.running.set(session.id, true);
      if (session === this.session) {
        this.resumptions.fire();
      }
    }
  }

  private async begin(session: vscode.DebugSession): Promise<void> {
    this.running.set(session.id, true);
    await session.customRequest("val3/subscribe", { motion: SAMPLING, io: true, userPage: true });
    this.sessions.fire();
    await this.show();
  }

  /** Sets whether the page that shows the robot receives messages. They begin with the present state. */
  async showView(isShown: boolean): Promise<void> {
    await this.request("val3/subscribe", { view: isShown });
  }

  /** Shows the present state. */
  private async show(): Promise<void> {
    this.changes.fire();
    this.samples.fire(await this.request("val3/pose", {}));
    this.pages.fire(await this.request("val3/userPage", {}));
  }

  private take(event: string, body: unknown): void {
    if (event === "val3/motion") {
      this.samples.fire((body as { samples: Sample[] }).samples.at(-1));
      this.changeSoon();
    } else if (event === "val3/io") {
      this.changeSoon();
    } else if (event === "val3/userPage") {
      this.pages.fire(body as UserPage);
    } else if (event === "val3/view") {
      this.views.fire((body as { messages: Message[] }).messages);
    }
  }

  private changeSoon(): void {
    this.pause ??= setTimeout(() => {
      this.pause = undefined;
      this.changes.fire();
    }, PAUSE);
  }
}
