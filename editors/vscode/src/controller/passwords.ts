// Passwords of controllers. They are stored in memory until the window is closed, and passed in VAL3_PASSWORD.

import * as vscode from "vscode";
import { serverOf } from "./address";

export class Passwords {
  /** Passwords by address. */
  private readonly entered = new Map<string, string>();

  /** Returns the environment of `val3` for a controller. Without an entered password, `val3` reads `~/.netrc`. */
  variables(address: string): NodeJS.ProcessEnv {
    const password = this.entered.get(address);
    return password === undefined ? process.env : { ...process.env, VAL3_PASSWORD: password };
  }

  /** Prompts for a password after a rejected login. Returns whether the user has entered one. */
  async prompt(address: string): Promise<boolean> {
    const server = serverOf(address);
    if (server === undefined) {
      return false;
    }
    const wasRejected = this.entered.delete(address);
    const password = await vscode.window.showInputBox({
      title: `Password of the profile ${server.profile} at ${server.host}`,
      prompt: wasRejected
        ? "The controller rejected the password. Enter the connectionPassword of the profile, not the one for the pendant."
        : "The connectionPassword of the profile. It is not stored, and is used until the window is closed.",
      password: true,
      ignoreFocusOut: true,
    });
    if (password !== undefined) {
      this.entered.set(address, password);
    }
    return password !== undefined;
  }
}
