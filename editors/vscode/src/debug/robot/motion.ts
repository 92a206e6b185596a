// Motion in step mode, and the line whose move the arm executes.

import * as vscode from "vscode";
import type { DebuggedRun, MotionMode, Sample, Source } from "../run";
import { lineInCode, type View, type Views } from "../sources";

/** Context key for the commands in the debug toolbar. */
const STEPS = "val3.stepsMotion";

const HINT = "The arm executes the move of this line.";

export function registerMotion(
  run: DebuggedRun,
  views: Views,
  icons: vscode.Uri,
  report: (fault: unknown) => void,
): vscode.Disposable[] {
  const showMode = async (): Promise<void> => {
    const answer = await run.request("val3/motionMode", {});
    await vscode.commands.executeCommand("setContext", STEPS, answer?.mode === "step");
  };
  const setMode = async (mode: MotionMode): Promise<void> => {
    await run.change("val3/motionMode", { mode });
  };
  return [
    vscode.Disposable.from(new MovingLine(run, views, icons)),
    run.onDidChange(() => void showMode().catch(report)),
    vscode.commands.registerCommand("val3.motionStep", () => run.change("val3/motionStep", {})),
    vscode.commands.registerCommand("val3.motionStepwise", () => setMode("step")),
    vscode.commands.registerCommand("val3.motionContinuous", () => setMode("continuous")),
    vscode.commands.registerCommand("val3.openLine", (source: Line, preserveFocus?: boolean) => openLine(source, views, preserveFocus)),
  ];
}

/** Marks the line whose move the arm executes. VS Code marks the line that the program executes. */
class MovingLine implements vscode.Disposable {
  private readonly mark: vscode.TextEditorDecorationType;
  private readonly subscription: vscode.Disposable;
  private source: Source | undefined;

  constructor(run: DebuggedRun, private readonly views: Views, icons: vscode.Uri) {
    const icon = (theme: string): vscode.Uri => vscode.Uri.joinPath(icons, `arm-${theme}.svg`);
    this.mark = vscode.window.createTextEditorDecorationType({
      isWholeLine: true,
      backgroundColor: new vscode.ThemeColor("val3.movingLineBackground"),
      overviewRulerColor: new vscode.ThemeColor("val3.movingLineBackground"),
      overviewRulerLane: vscode.OverviewRulerLane.Center,
      light: { gutterIconPath: icon("light") },
      dark: { gutterIconPath: icon("dark") },
      gutterIconSize: "contain",
    });
    this.subscription = vscode.Disposable.from(
      run.onDidMove((sample) => this.follow(sample)),
      vscode.window.onDidChangeVisibleTextEditors(() => this.show()),
      vscode.workspace.onDidChangeTextDocument(() => this.show()),
    );
  }

  dispose(): void {
    vscode.Disposable.from(this.subscription, this.mark).dispose();
  }

  private follow(sample: Sample | undefined): void {
    const source = sample?.source ?? undefined;
    if (source?.file !== this.source?.file || source?.line !== this.source?.line) {
      this.source = source;
      this.show();
    }
  }

  private show(): void {
    const places = this.source === undefined ? [] : placesOf(this.source, this.views);
    for (const editor of vscode.window.visibleTextEditors) {
      const own = places.filter(({ uri, line }) => uri.toString() === editor.document.uri.toString() && line < editor.document.lineCount);
      editor.setDecorations(this.mark, own.map(({ line }) => ({ range: editor.document.lineAt(line).range, hoverMessage: HINT })));
    }
  }
}

/** Line of a file, from 1. */
type Line = Pick<Source, "file" | "line">;

/** Line of a document, from 0. */
interface Place {
  uri: vscode.Uri;
  line: number;
}

/** Returns the line in its file, preceded by the line in visible code views. */
function placesOf({ file, line }: Line, views: Views): [...Place[], Place] {
  const inView = ({ code, mapping }: View): Place[] => {
    const found = lineInCode(line, mapping);
    return found === undefined ? [] : [{ uri: vscode.Uri.parse(code, true), line: found - 1 }];
  };
  return [...views.shown(file).flatMap(inView), { uri: vscode.Uri.file(file), line: line - 1 }];
}

/** Opens the line beside a web view that is active, not instead of it. */
async function openLine(source: Line, views: Views, preserveFocus = false): Promise<void> {
  const [{ uri, line }] = placesOf(source, views);
  const at = new vscode.Position(line, 0);
  const viewColumn = columnFor(uri);
  await vscode.window.showTextDocument(uri, { selection: new vscode.Range(at, at), preserveFocus, ...(viewColumn && { viewColumn }) });
}

/** Returns the group of editors for a document if a web view is active: the group that shows the document, or text. */
function columnFor(uri: vscode.Uri): vscode.ViewColumn | undefined {
  const { tabGroups: { activeTabGroup }, visibleTextEditors: editors } = vscode.window;
  if (!(activeTabGroup.activeTab?.input instanceof vscode.TabInputWebview)) {
    return undefined;
  }
  const shown = editors.find(({ document }) => document.uri.toString() === uri.toString()) ?? editors.find(({ viewColumn }) => viewColumn !== undefined);
  return shown?.viewColumn;
}
