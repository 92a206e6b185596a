// Output of `val3 test`: the tests of applications, events during their execution, and the coverage of files.

/** Output of `val3 test --list --format json`. */
export interface Listing {
  applications: ListedApplication[];
}

export interface ListedApplication {
  name: string;
  /** Path of the `.pjx`. */
  file: string;
  folder: string;
  /** `null` if the application cannot be executed. */
  tests: ListedTest[] | null;
  /** Reason why it cannot. */
  error: string | null;
}

export interface ListedTest {
  /** `application:program`. */
  name: string;
  program: string;
  file: string;
  /** From 1. */
  line: number;
}

/** Line of `--format json-lines`. */
export type Line = { kind: "started"; test: ListedTest } | { kind: "finished"; test: Result } | { kind: "summary" };

export interface Result extends ListedTest {
  passed: boolean;
  /** Duration on the controller's clock. */
  seconds: number;
  /** Real duration; the debugger does not measure it. */
  wallSeconds?: number;
  prints: string[];
  failure: Failure | null;
  /** Reason why the test neither passes nor fails. */
  exemption?: Exemption | null;
}

export interface Exemption {
  kind: "skipped" | "knownFailure";
  reason: string;
}

export interface Failure {
  message: string;
  /** The innermost first. */
  places: Place[];
  /** Further failures of the same test. */
  others?: Failure[];
}

export interface Place {
  program: string;
  file: string;
  line: number;
}

/** Returns the values of both sides of an assertion; `undefined` if the message has another form. */
export function sides(message: string): { actual: string; expected: string } | undefined {
  const lines = /^ {2}actual {4}(.*)\n {2}expected {2}(.*)$/m.exec(message);
  const [, actual, expected] = lines ?? /^("[^"]*"|\S+) instead of ("[^"]*"|\S+)(?: \(.*\))?$/.exec(message) ?? [];
  return actual === undefined || expected === undefined ? undefined : { actual, expected };
}

/** Returns the innermost location of a failure that has a file. */
export function placeOf({ places }: Failure): Place | undefined {
  return places.find(({ file }) => file !== "");
}

/** Returns all failures of a test. */
export function all(failure: Failure | null): Failure[] {
  return failure === null ? [] : [failure, ...(failure.others ?? [])];
}

/** Formats a result for the output of a test run, where lines end with CR LF. */
export function output({ name, passed, seconds, prints, failure, exemption }: Result): string {
  const reason = exemption ? `, ${exemption.kind === "skipped" ? "skipped" : "known failure"}: ${exemption.reason}` : "";
  const head = `${exemption ? "skip" : passed ? "ok  " : "FAIL"} ${name} (${seconds.toFixed(3)} s of controller time)${reason}`;
  const message = all(failure).flatMap(({ message }) => message.split("\n").map((line) => `     ${line}`));
  const printed = prints.map((line) => `     | ${line}`);
  return [head, ...message, ...printed].map((line) => `${line}\r\n`).join("");
}

/** Whether a test is a scenario, whose file is a script. */
export function isScenario(file: string): boolean {
  return /\.toml$/i.test(file);
}

/** Collects the output of a process and forwards each complete line. */
export class LineReader {
  private rest = "";

  constructor(private readonly receive: (line: string) => void) {}

  push(text: string): void {
    const lines = (this.rest + text).split("\n");
    this.rest = lines.pop() ?? "";
    lines.filter((line) => line !== "").forEach(this.receive);
  }
}
