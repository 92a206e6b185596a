// Selection of the tests that one process executes, and its arguments.

/** Properties of a test that its selection needs. */
export interface ChosenTest {
  /** `application:program`, optionally with a row, or `application:scenario`. */
  name: string;
  /** Path by which `val3 test` finds the test: the folder of the application, or the file of a scenario. */
  path: string;
}

/** Tests that one process executes. */
export interface Batch<Test extends ChosenTest = ChosenTest> {
  paths: string[];
  tests: Test[];
  /** Names to select; empty if the paths contain no other tests. */
  names: string[];
}

/**
 * Divides the selected tests into as few processes as possible, such that a name is unique in each process. `all` are
 * the tests in the workspace.
 */
export function batches<Test extends ChosenTest>(chosen: readonly Test[], all: readonly ChosenTest[]): Batch<Test>[] {
  const batches: { paths: string[]; tests: Map<string, Test> }[] = [];
  for (const [path, tests] of byPath(chosen)) {
    let batch = batches.find((batch) => !tests.some(({ name }) => batch.tests.has(name)));
    if (batch === undefined) {
      batch = { paths: [], tests: new Map() };
      batches.push(batch);
    }
    batch.paths.push(path);
    tests.forEach((test) => batch.tests.set(test.name, test));
  }
  return batches.map(({ paths, tests }) => {
    const found = all.filter(({ path }) => paths.some((folder) => isBelow(path, folder)));
    return { paths, tests: [...tests.values()], names: found.length === tests.size ? [] : [...tests.keys()] };
  });
}

function byPath<Test extends ChosenTest>(tests: readonly Test[]): Map<string, Test[]> {
  const found = new Map<string, Test[]>();
  for (const test of tests) {
    found.set(test.path, [...(found.get(test.path) ?? []), test]);
  }
  return found;
}

function isBelow(path: string, folder: string): boolean {
  return path === folder || path.startsWith(`${folder}/`) || path.startsWith(`${folder}\\`);
}

/** Returns the arguments of `val3` for a batch. `coverage` is the file for its coverage. */
export function testArguments({ paths, names }: Batch, coverage?: string): string[] {
  const exact = names.flatMap((name) => ["--exact", name]);
  const measured = coverage === undefined ? [] : ["--coverage-output", `json=${coverage}`];
  return ["test", "--format", "json-lines", ...exact, ...measured, "--", ...paths];
}
