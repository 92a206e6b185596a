// Coverage of files that `val3 test --coverage-output json=FILE` writes.

export interface CoverageReport {
  /** One entry per program; a file may have several. */
  files: CoveredFile[];
}

export interface CoveredFile {
  file: string;
  lines: CoveredLine[];
  branches: CoveredBranch[];
}

export interface CoveredLine {
  /** From 1. */
  line: number;
  hits: number;
}

export interface CoveredBranch {
  line: number;
  sides: { name: string; hits: number }[];
}

export interface Count {
  covered: number;
  total: number;
}

/** Returns the files of a report without duplicates. */
export function filesOf({ files }: CoverageReport): CoveredFile[] {
  const found = new Map<string, CoveredFile>();
  for (const { file, lines, branches } of files) {
    const known = found.get(file);
    found.set(file, { file, lines: [...(known?.lines ?? []), ...lines], branches: [...(known?.branches ?? []), ...branches] });
  }
  return [...found.values()];
}

/** Counts the executed lines among all lines with code. */
export function lineCount({ lines }: CoveredFile): Count {
  return count(lines);
}

/** Counts the executed sides among all sides of branches. */
export function sideCount({ branches }: CoveredFile): Count {
  return count(branches.flatMap(({ sides }) => sides));
}

/** Returns the branches of a line. */
export function branchesOf({ branches }: CoveredFile, { line }: CoveredLine): CoveredBranch[] {
  return branches.filter((branch) => branch.line === line);
}

function count(counted: readonly { hits: number }[]): Count {
  return { covered: counted.filter(({ hits }) => hits > 0).length, total: counted.length };
}
