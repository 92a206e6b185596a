// The tests that one process executes, and its arguments.

/** A test as far as its choice needs it. */
export interface ChosenTest {
  /** `application:program`. */
  name: string;
  /** The folder of the application. */
  folder: string;
}

/** Tests of applications that one process executes. */
export interface Batch {
  folders: string[];
  tests: ChosenTest[];
  /** The names to choose; none if they are all tests of their applications. */
  names: string[];
}

/**
 * The chosen tests in as few processes as possible: a name means one test in each. `all` are the tests of the workspace.
 */
export function batches(chosen: readonly ChosenTest[], all: readonly ChosenTest[]): Batch[] {
  const batches: (Batch & { taken: Set<string> })[] = [];
  for (const [folder, tests] of byFolder(chosen)) {
    const names = tests.map(({ name }) => name);
    let batch = batches.find(({ taken }) => !names.some((name) => taken.has(name)));
    if (batch === undefined) {
      batch = { folders: [], tests: [], names: [], taken: new Set() };
      batches.push(batch);
    }
    batch.folders.push(folder);
    batch.tests.push(...tests);
    names.forEach((name) => batch.taken.add(name));
  }
  return batches.map(({ folders, tests }) => {
    const count = all.filter(({ folder }) => folders.includes(folder)).length;
    return { folders, tests, names: count === tests.length ? [] : tests.map(({ name }) => name) };
  });
}

function byFolder(tests: readonly ChosenTest[]): Map<string, ChosenTest[]> {
  const found = new Map<string, ChosenTest[]>();
  for (const test of tests) {
    found.set(test.folder, [...(found.get(test.folder) ?? []), test]);
  }
  return found;
}

/** The arguments of `val3` for a batch. `coverage` is the file that its coverage is written to. */
export function testArguments({ folders, names }: Batch, coverage?: string): string[] {
  const exact = names.flatMap((name) => ["--exact", name]);
  const measured = coverage === undefined ? [] : ["--coverage-output", `json=${coverage}`];
  return ["test", "--format", "json-lines", ...exact, ...measured, "--", ...folders];
}
