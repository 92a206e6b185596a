// Process `val3` that exchanges files with a controller.

import { spawn } from "node:child_process";

export interface Ended {
  /** Exit code; `null` if a signal has ended the process. */
  code: number | null;
  output: Buffer;
  /** Standard error output. */
  errors: string;
}

export interface Environment {
  folder: string;
  variables: NodeJS.ProcessEnv;
  /** Calls its argument when the user cancels. */
  onCancel: (listener: () => void) => unknown;
  /** Receives the error output while the process runs. */
  progress: (text: string) => void;
}

/**
 * Runs a command to its end. Cancelling sends SIGINT, like Ctrl-C: the process cleans up on the controller, or completes
 * its last steps, and then ends.
 */
export async function run(command: string, words: readonly string[], { folder, variables, onCancel, progress }: Environment): Promise<Ended> {
  return new Promise((resolve) => {
    const child = spawn(command, words, { cwd: folder, env: variables, stdio: ["ignore", "pipe", "pipe"] });
    const output: Buffer[] = [];
    let errors = "";
    const add = (text: string): void => {
      errors += text;
      progress(text);
    };
    onCancel(() => child.kill("SIGINT"));
    child.stdout.on("data", (bytes: Buffer) => output.push(bytes));
    child.stderr.setEncoding("utf8").on("data", add);
    child.on("error", (fault) => add(`error: ${command} cannot be started: ${fault.message}\n`));
    child.on("close", (code) => resolve({ code, output: Buffer.concat(output), errors }));
  });
}
