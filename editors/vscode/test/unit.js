// Bundles and runs the tests that need no editor.
const { spawnSync } = require("node:child_process");
const { join } = require("node:path");
const { buildSync } = require("esbuild");

const bundle = join(__dirname, "../dist/test/codeView.test.js");
buildSync({ entryPoints: [join(__dirname, "codeView.test.ts")], outfile: bundle, bundle: true, platform: "node", external: ["vscode"] });
const { status, stdout } = spawnSync(process.execPath, ["--test", "--test-reporter=tap", bundle], { encoding: "utf8" });
const count = (word) => Number(new RegExp(`^# ${word} (\\d+)`, "m").exec(stdout)?.[1] ?? 0);
if (status !== 0) {
  console.log(stdout);
}
console.log(`test result: ${status === 0 ? "ok" : "FAILED"}. ${count("pass")} passed; ${count("fail")} failed; code view`);
process.exitCode = status === 0 ? 0 : 1;
