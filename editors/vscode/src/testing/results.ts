// What `val3 test` writes: the tests of applications, what happens while they are executed, and the coverage of files.

/** The object of `val3 test --list --format json`. */
export interface Listing {
  applications: ListedApplication[];
}

export interface ListedApplication {
  name: string;
  /** Its `.pjx`. */
  file: string;
  folder: string;
  /** Nothing if the application cannot be executed. */
  tests: ListedTest[] | null;
  /** The reason. */
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

/** A line of `--format json-lines`. */
export type Line = { kind: "started"; test: ListedTest } | { kind: "finished"; test: Result } | { kind: "summary" };

export interface Result extends ListedTest {
  passed: boolean;
  /** Of the controller's clock. */
  seconds: number;
  prints: string[];
  failure: Failure | null;
  /** Why the test neither passes nor fails. */
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

/** The values of both sides of an assertion; nothing if the message has others. */
export function sides(message: string): { actual: string; expected: string } | undefined {
  const lines = /^ {2}actual {4}(.*)\n {2}expected {2}(.*)$/m.exec(message);
  const [, actual, expected] = lines ?? /^("[^"]*"|\S+) instead of ("[^"]*"|\S+)(?: \(.*\))?$/.exec(message) ?? [];
  return actual === undefined || expected === undefined ? undefined : { actual, expected };
}

/** The innermost place of a failure that has a file. */
export function placeOf({ places }: Failure): Place | undefined {
  return places.find(({ file }) => file !== "");
}

/** All failures of a test. */
export function all(failure: Failure | null): Failure[] {
  return failure === null ? [] : [failure, ...(failure.others ?? [])];
}

/** The text of a result in the output of a test run, where lines end with CR LF. */
export function output({ name, passed, seconds, prints, failure, exemption }: Result): string {
  const reason = exemption ? `, ${exemption.kind === "skipped" ? "skipped" : "known failure"}: ${exemption.reason}` : "";
  const head = `${exemption ? "skip" : passed ? "ok  " : "FAIL"} ${name} (${seconds.toFixed(3)} s)${reason}`;
  const message = all(failure).flatMap(({ message }) => message.split("\n").map((line) => `     ${line}`));
  const printed = prints.map((line) => `     | ${line}`);
  return [head, ...message, ...printed].map((line) => `${line}\r\n`).join("");
}

/** Whether a test is a scenario: the file of one is a script. */
export function isScenario(file: string): boolean {
  return /\.toml$/i.test(file);
}

/** Collects the output of a process and passes each whole line on. */
export class LineReader {
  private rest = "";

  constructor(private readonly receive: (line: string) => void) {}

  push(text: string): void {
    const lines = (this.rest + text).split("\n");
    this.rest = lines.pop() ?? "";
    lines.filter((line) => line !== "").forEach(this.receive);
  }
}
