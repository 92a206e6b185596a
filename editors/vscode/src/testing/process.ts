// A process `val3 test`.

import { spawn } from "node:child_process";
import { LineReader } from "./results";

export interface Ended {
  /** Nothing if a signal has ended it. */
  code: number | null;
  /** What it has written to the standard error output. */
  errors: string;
}

/** Runs a command to its end and passes each line of its output on. `aborted` kills it. */
export async function follow(
  command: string,
  words: readonly string[],
  { folder, aborted, line }: { folder: string; aborted?: AbortSignal; line: (line: string) => void },
): Promise<Ended> {
  return new Promise((resolve) => {
    const child = spawn(command, words, { cwd: folder, signal: aborted, stdio: ["ignore", "pipe", "pipe"] });
    const reader = new LineReader(line);
    let errors = "";
    child.stdout.setEncoding("utf8").on("data", (text: string) => reader.push(text));
    child.stderr.setEncoding("utf8").on("data", (text: string) => (errors += text));
    child.on("error", (fault) => (errors += `${fault.message}\n`));
    child.on("close", (code) => {
      reader.push("\n");
      resolve({ code, errors });
    });
  });
}
