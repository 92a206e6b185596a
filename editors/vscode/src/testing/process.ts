// Process `val3 test`.

import { spawn } from "node:child_process";
import { LineReader } from "./results";

export interface Ended {
  /** Exit code; `null` if a signal has ended the process. */
  code: number | null;
  /** Standard error output. */
  errors: string;
}

/** Folder and output of a process. */
export interface Place {
  folder: string;
  /** Kills the process. */
  aborted?: AbortSignal;
  /** Receives each line of the output. */
  line: (line: string) => void;
}

/** Runs a command to its end and forwards each output line. */
export async function follow(command: string, words: readonly string[], { folder, aborted, line }: Place): Promise<Ended> {
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
