// Execution of tests by `val3 test`, with or without coverage.

import { mkdtemp, readFile, rm } from "node:fs/promises";
import { tmpdir } from "node:os";
import { join, resolve } from "node:path";
import * as vscode from "vscode";
import type { Client } from "../client";
import { type CoverageReport, filesOf } from "./coverage";
import { FileCoverage } from "./fileCoverage";
import { type Ended, follow, type Place } from "./process";
import { messageOf } from "./message";
import { all, type Line, output, type Result } from "./results";
import { type Batch, batches, testArguments } from "./selection";
import type { Test, TestTree } from "./tree";

/** Exit codes with results: all tests have passed, or some have failed. */
const WITH_RESULTS: (number | null)[] = [0, 1];

export class Execution {
  constructor(private readonly client: Client, private readonly tree: TestTree) {}

  /** Executes the requested tests. */
  async execute(request: vscode.TestRunRequest, isMeasured: boolean): Promise<void> {
    await vscode.workspace.saveAll(false);
    await this.tree.refresh();
    const chosen = chosenTests(request, this.tree);
    const run = this.tree.controller.createTestRun(request);
    const aborted = new AbortController();
    run.token.onCancellationRequested(() => aborted.abort());
    try {
      chosen.forEach(({ item }) => run.enqueued(item));
      for (const batch of batches(chosen, this.tree.all())) {
        await this.executeBatch(run, { batch, isMeasured, aborted: aborted.signal });
      }
    } finally {
      run.end();
    }
  }

  private async executeBatch(run: vscode.TestRun, work: Work): Promise<void> {
    if (!work.isMeasured) {
      await this.process(run, work);
      return;
    }
    const folder = await mkdtemp(join(tmpdir(), "val3-coverage-"));
    try {
      const file = join(folder, "coverage.json");
      const base = await this.process(run, work, file);
      const report = await readFile(file, "utf8").catch(() => undefined);
      const files = report === undefined ? [] : filesOf(JSON.parse(report) as CoverageReport);
      files.forEach((covered) => run.addCoverage(new FileCoverage(vscode.Uri.file(resolve(base, covered.file)), covered)));
    } finally {
      await rm(folder, { recursive: true });
    }
  }

  /** Executes a batch. Returns the folder to which its paths are relative. */
  private async process(run: vscode.TestRun, { batch, aborted }: Work, coverage?: string): Promise<string> {
    const [{ folder } = { folder: "." }] = batch.tests;
    const open = new Map(batch.tests.map((test) => [test.name, test]));
    const line = (text: string): void => show(run, JSON.parse(text) as Line, { open, folder });
    const words = testArguments(batch, coverage);
    const { code, errors } = await this.follow(words, { folder, aborted, line });
    if (aborted.aborted) {
      open.forEach(({ item }) => run.skipped(item));
    } else if (!WITH_RESULTS.includes(code)) {
      run.appendOutput(errors.replaceAll("\n", "\r\n"));
      open.forEach(({ item }) => run.errored(item, new vscode.TestMessage(errors.trim())));
    }
    return folder;
  }

  /** Runs nothing if the server was not found: Windows would look for a command without a path in the folder first. */
  private async follow(words: readonly string[], place: Place): Promise<Ended> {
    const { command } = this.client;
    return command === undefined ? { code: null, errors: "The server val3 was not found.\n" } : follow(command, words, place);
  }
}

interface Work {
  batch: Batch<Test>;
  isMeasured: boolean;
  aborted: AbortSignal;
}

/** Returns the tests that a request includes and does not exclude. */
export function chosenTests({ include, exclude }: vscode.TestRunRequest, tree: TestTree): Test[] {
  const excluded = new Set((exclude ?? []).flatMap((item) => tree.below(item)));
  const included = include === undefined ? tree.all() : include.flatMap((item) => tree.below(item));
  return [...new Set(included)].filter((test) => !excluded.has(test));
}

function show(run: vscode.TestRun, line: Line, { open, folder }: { open: Map<string, Test>; folder: string }): void {
  if (line.kind === "summary") {
    return;
  }
  const item = open.get(line.test.name)?.item;
  if (item === undefined) {
    return;
  } else if (line.kind === "started") {
    run.started(item);
  } else {
    open.delete(line.test.name);
    finish(run, item, line.test, folder);
  }
}

/** Shows the result of a test. Its paths are relative to `folder`. */
export function finish(run: vscode.TestRun, item: vscode.TestItem, result: Result, folder: string): void {
  run.appendOutput(output(result), undefined, item);
  // The Testing view adds up real time.
  const milliseconds = result.wallSeconds === undefined ? undefined : result.wallSeconds * 1000;
  if (result.exemption?.kind === "skipped") {
    run.skipped(item);
  } else if (result.failure === null) {
    run.passed(item, milliseconds);
  } else {
    run.failed(item, all(result.failure).map((failure) => messageOf(failure, folder)), milliseconds);
  }
}
