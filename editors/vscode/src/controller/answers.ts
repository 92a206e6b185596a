// JSON output of `val3 status` and `val3 push --dry-run`. Pure functions.

/** Side that has changed a file since the last pull or push; `alike` if both sides have the same new version. */
export type Side = "local" | "controller" | "conflict" | "alike";

export type FileChange = "added" | "changed" | "removed";

export interface DifferingFile {
  /** Path on the controller, and below the project's folder: `usr/usrapp/demo/start.pgx`. */
  path: string;
  side: Side;
  /** For a conflict, the local change. */
  change: FileChange;
  /** Change of the controller's file in a conflict. */
  controller_change?: FileChange;
}

export interface ComparedApplication {
  /** Folder below `usr/usrapp`. */
  name: string;
  files: DifferingFile[];
}

/** Output of `val3 status`. */
export interface Comparison {
  /** All applications, also those without differences. */
  applications: ComparedApplication[];
  /** Differing files outside `usr/usrapp`. */
  settings: DifferingFile[];
}

export interface PlannedChange {
  path: string;
  action: "create" | "replace" | "remove";
  /** Bytes of the new file; `null` if it is removed. */
  size: number | null;
}

/** Output of `val3 push --dry-run`. */
export interface Plan {
  changes: PlannedChange[];
}

/** Version of the output that these types describe. */
const VERSION = 1;

/** Parses the output of `val3 status --format json`. Throws if it has another version. */
export function parseComparison(output: Buffer): Comparison {
  return parse(output) as Comparison;
}

/** Parses the output of `val3 push --dry-run --format json`. Throws if it has another version. */
export function parsePlan(output: Buffer): Plan {
  return parse(output) as Plan;
}

function parse(output: Buffer): unknown {
  const answer = JSON.parse(output.toString("utf8")) as { version?: unknown };
  if (answer.version !== VERSION) {
    throw new Error(`val3 wrote version ${String(answer.version)} of its output, and the extension reads version ${VERSION}. `
      + "Install the extension and val3 of the same release.");
  }
  return answer;
}
