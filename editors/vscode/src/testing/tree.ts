// Tree of the Testing view: applications and their tests, from `val3 test --list`.

import { resolve } from "node:path";
import * as vscode from "vscode";
import type { Client } from "../client";
import { follow } from "./process";
import { isScenario, type ListedApplication, type ListedTest, type Listing } from "./results";
import type { ChosenTest } from "./selection";

/** Milliseconds from the last change of a file until the tests are listed again. */
const PAUSE = 500;

/** Test in the tree. */
export interface Test extends ChosenTest {
  program: string;
  /** Application folder. */
  folder: string;
  item: vscode.TestItem;
}

export class TestTree implements vscode.Disposable {
  readonly controller = vscode.tests.createTestController("val3", "VAL 3");
  private readonly tests = new Map<string, Test>();
  private readonly subscription: vscode.Disposable;
  private pause: NodeJS.Timeout | undefined;
  /** Serialises the listings. */
  private turns: Promise<void> = Promise.resolve();

  constructor(private readonly client: Client, private readonly output: vscode.LogOutputChannel) {
    const watcher = vscode.workspace.createFileSystemWatcher("**/*.{pgx,pjx,dtx,toml,PGX,PJX,DTX}");
    this.controller.refreshHandler = () => this.refresh();
    this.subscription = vscode.Disposable.from(
      this.controller,
      watcher,
      watcher.onDidChange(() => this.refreshLater()),
      watcher.onDidCreate(() => this.refreshLater()),
      watcher.onDidDelete(() => this.refreshLater()),
      vscode.workspace.onDidChangeWorkspaceFolders(() => this.refreshLater()),
    );
  }

  dispose(): void {
    clearTimeout(this.pause);
    this.subscription.dispose();
  }

  /** Lists the tests in the present files. */
  async refresh(): Promise<void> {
    clearTimeout(this.pause);
    this.turns = this.turns.then(() => this.list()).catch((fault: unknown) => this.output.error(String(fault)));
    await this.turns;
  }

  /** Returns all tests. */
  all(): Test[] {
    return [...this.tests.values()];
  }

  /** Returns an item's tests: its own one, or the application's tests. */
  below(item: vscode.TestItem): Test[] {
    return this.all().filter((test) => test.item === item || test.item.parent === item);
  }

  /** Returns the tests for a program of the application in a folder: several if the test has a table. */
  find(folder: string, program: string): Test[] {
    return this.all().filter((test) => test.folder === folder && test.program === program);
  }

  private refreshLater(): void {
    clearTimeout(this.pause);
    this.pause = setTimeout(() => void this.refresh(), PAUSE);
  }

  private async list(): Promise<void> {
    const [first, ...others] = vscode.workspace.workspaceFolders ?? [];
    if (first === undefined || this.client.command === undefined) {
      this.show([], "");
      return;
    }
    const folder = first.uri.fsPath;
    const words = ["test", "--list", "--format", "json", "--", ".", ...others.map(({ uri }) => uri.fsPath)];
    const lines: string[] = [];
    const { code, errors } = await follow(this.client.command, words, { folder, line: (line) => lines.push(line) });
    if (code === 0) {
      this.show((JSON.parse(lines.join("\n")) as Listing).applications, folder);
    } else {
      // The previous tests are better than none.
      this.output.warn(`val3 test --list: ${errors}`);
    }
  }

  private show(applications: readonly ListedApplication[], folder: string): void {
    this.tests.clear();
    const items = applications.map((application) => this.applicationItem(application, folder));
    this.controller.items.replace(items);
  }

  /** Existing items keep their results. */
  private applicationItem({ name, file, folder, tests, error }: ListedApplication, base: string): vscode.TestItem {
    const own = resolve(base, folder);
    const item = this.controller.items.get(own) ?? this.controller.createTestItem(own, name, vscode.Uri.file(resolve(base, file)));
    item.error = error ?? undefined;
    item.children.replace((tests ?? []).map((test) => this.testItem(item, test, own, base)));
    return item;
  }

  private testItem(parent: vscode.TestItem, test: ListedTest, folder: string, base: string): vscode.TestItem {
    const id = `${folder}:${test.name}`;
    const label = test.name.slice(test.name.indexOf(":") + 1);
    const uri = vscode.Uri.file(resolve(base, test.file));
    const known = parent.children.get(id);
    const item = known?.uri?.toString() === uri.toString() ? known : this.controller.createTestItem(id, label, uri);
    item.range = new vscode.Range(test.line - 1, 0, test.line - 1, 0);
    const path = isScenario(uri.fsPath) ? uri.fsPath : folder;
    this.tests.set(id, { name: test.name, program: test.program, path, folder, item });
    return item;
  }
}
