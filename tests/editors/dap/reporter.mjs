// Prints each test in the format of the other editor tests. The suite has the name of its last folder.
import { basename, dirname } from "node:path";

export default async function* reporter(events) {
  let suite = "no tests";
  const count = { "test:pass": 0, "test:fail": 0 };
  for await (const { type, data } of events) {
    // A file is a test that consists of its tests.
    if (!(type in count) || /\.test\.m?js$/.test(data.name)) continue;
    count[type] += 1;
    suite = basename(dirname(data.file));
    if (type === "test:pass") {
      yield `ok ${data.name} (${Math.round(data.details.duration_ms)} ms)\n`;
    } else {
      yield `FAILED ${data.name}\n${data.details.error.cause?.stack ?? data.details.error}\n`;
    }
  }
  const { "test:pass": passed, "test:fail": failed } = count;
  yield `test result: ${failed === 0 ? "ok" : "FAILED"}. ${passed} passed; ${failed} failed; ${suite}\n`;
}
