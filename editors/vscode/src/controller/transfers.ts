// Commands of `val3` for a controller, with progress, cancellation, passwords and messages.

import * as vscode from "vscode";
import type { Client } from "../client";
import { reason } from "../tree/changes";
import { confirmCertificate } from "./certificates";
import { isLoginRejected, messageOf, unknownFingerprint } from "./messages";
import type { Passwords } from "./passwords";
import { type Ended, run } from "./process";

/** A command of `val3`. */
export interface Transfer {
  /** Title of the progress notification. */
  title: string;
  /** Folder in which the command runs. */
  folder: string;
  /** Address of the controller, under which its password is stored. */
  address: string;
  subcommand: "pull" | "status" | "push";
  words: readonly string[];
  /** Whether the output is text for the output channel. */
  showsOutput?: boolean;
  /** Whether open files are not saved, because the command reads no local files. */
  keepsEdits?: boolean;
}

export interface Finished extends Ended {
  isCancelled: boolean;
}

const SHOW_OUTPUT = "Show Output";

export class Transfers implements vscode.Disposable {
  private readonly channel = vscode.window.createOutputChannel("VAL 3 Controller");
  /** Folders of running commands. */
  private readonly busy = new Set<string>();

  constructor(private readonly client: Client, private readonly passwords: Passwords) {}

  dispose(): void {
    this.channel.dispose();
  }

  /**
   * Runs a command, usually after saving all files. Returns `undefined`, with a message, if it cannot be started. If the
   * certificate of a new controller is not known, asks for it, and if the login is rejected, prompts for the password, and
   * repeats the command.
   */
  async run(transfer: Transfer): Promise<Finished | undefined> {
    const { command } = this.client;
    const { folder } = transfer;
    if (command === undefined) {
      void vscode.window.showErrorMessage("The connection to a controller needs the server val3, which was not found.");
      return undefined;
    }
    if (this.busy.has(folder)) {
      void vscode.window.showInformationMessage(`A command for the controller of ${folder} is still running. Wait for its end, or cancel it.`);
      return undefined;
    }
    this.busy.add(folder);
    try {
      await (transfer.keepsEdits === true || vscode.workspace.saveAll(false));
      let attempted = transfer;
      let finished = await this.attempt(command, attempted);
      const fingerprint = transfer.subcommand === "pull" ? unknownFingerprint(finished.errors) : undefined;
      if (fingerprint !== undefined && (await confirmCertificate(transfer.address, fingerprint))) {
        attempted = { ...transfer, words: ["--fingerprint", fingerprint, ...transfer.words] };
        finished = await this.attempt(command, attempted);
      }
      while (isRejected(finished) && (await this.passwords.prompt(transfer.address))) {
        finished = await this.attempt(command, attempted);
      }
      return finished;
    } finally {
      this.busy.delete(folder);
    }
  }

  /** Shows why a command has not reached its aim. Returns the button that the user selects. */
  async showFailure({ errors, isCancelled }: Finished, ...buttons: string[]): Promise<string | undefined> {
    const message = reason(messageOf(errors) || (isCancelled ? "The command was cancelled" : "val3 ended without a message"));
    if (isCancelled) {
      void vscode.window.showInformationMessage(message);
      return undefined;
    }
    const choice = await vscode.window.showErrorMessage(message, ...buttons, SHOW_OUTPUT);
    if (choice === SHOW_OUTPUT) {
      this.channel.show();
    }
    return choice;
  }

  private async attempt(command: string, { title, folder, address, subcommand, words, showsOutput }: Transfer): Promise<Finished> {
    const options = { location: vscode.ProgressLocation.Notification, title, cancellable: true };
    this.channel.appendLine(`> ${["val3", subcommand, ...words].join(" ")}`);
    const finished = await vscode.window.withProgress(options, async (progress, token) => {
      const ended = await run(command, [subcommand, "--color", "never", ...words], {
        folder,
        variables: this.passwords.variables(address),
        onCancel: token.onCancellationRequested,
        progress: (text) => {
          this.channel.append(text);
          // The title contains the address. Errors have their own message.
          const line = text.trimEnd().split("\n").at(-1)?.replace(`${address}: `, "");
          progress.report({ message: isError(text) ? undefined : line });
        },
      });
      return { ...ended, isCancelled: token.isCancellationRequested };
    });
    this.channel.append(showsOutput === true ? finished.output.toString("utf8") : "");
    return finished;
  }
}

function isError(text: string): boolean {
  return /^error\b/m.test(text);
}

function isRejected({ code, errors, isCancelled }: Finished): boolean {
  return code !== 0 && !isCancelled && isLoginRejected(errors);
}
