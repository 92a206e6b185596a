// Coverage of a file for the editor: its lines and branch sides.

import * as vscode from "vscode";
import { branchesOf, type Count, type CoveredFile, type CoveredLine, lineCount, sideCount } from "./coverage";

export class FileCoverage extends vscode.FileCoverage {
  constructor(uri: vscode.Uri, private readonly covered: CoveredFile) {
    super(uri, counted(lineCount(covered)), counted(sideCount(covered)));
  }

  details(): vscode.StatementCoverage[] {
    return this.covered.lines.map((line) => this.statement(line));
  }

  private statement(line: CoveredLine): vscode.StatementCoverage {
    const place = new vscode.Position(line.line - 1, 0);
    const sides = branchesOf(this.covered, line).flatMap(({ sides }) => sides);
    const branches = sides.map(({ name, hits }) => new vscode.BranchCoverage(hits, place, name));
    return new vscode.StatementCoverage(line.hits, place, branches);
  }
}

function counted({ covered, total }: Count): vscode.TestCoverageCount {
  return new vscode.TestCoverageCount(covered, total);
}
