// Ticks the steps of the walkthrough, including steps that were completed before it was opened.
//
// VS Code detects the completion of a step only while the walkthrough is loaded, and never ticks a step whose context
// key is already set at that time. The context key of a step is therefore set for a moment: when the step is completed,
// and again when a walkthrough opens.

import * as vscode from "vscode";

export type Step = "open" | "new" | "code" | "check" | "debug" | "robot";

const KEY = "val3.stepsDone";

export class Walkthrough implements vscode.Disposable {
  private readonly subscription: vscode.Disposable;

  constructor(private readonly memory: vscode.Memento, private readonly report: (fault: unknown) => void) {
    this.subscription = vscode.window.tabGroups.onDidChangeTabs(({ opened, changed }) => this.show([...opened, ...changed]));
    this.show(vscode.window.tabGroups.all.flatMap(({ tabs }) => tabs));
  }

  dispose(): void {
    this.subscription.dispose();
  }

  done(step: Step): void {
    this.finish(step).catch(this.report);
  }

  private async finish(step: Step): Promise<void> {
    const before = this.steps();
    if (!before.includes(step)) {
      await this.memory.update(KEY, [...before, step]);
    }
    await tick(step);
  }

  /** Ticks the completed steps if a walkthrough is open. Its tab has a kind that extensions cannot read. */
  private show(tabs: readonly vscode.Tab[]): void {
    if (tabs.some(({ input }) => input === undefined)) {
      Promise.all(this.steps().map(tick)).catch(this.report);
    }
  }

  private steps(): Step[] {
    return this.memory.get<Step[]>(KEY, []);
  }
}

async function tick(step: Step): Promise<void> {
  for (const holds of [true, false]) {
    await vscode.commands.executeCommand("setContext", `val3.done.${step}`, holds);
  }
}
