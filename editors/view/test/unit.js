// Bundles and runs the tests that need no browser.
const { spawnSync } = require("node:child_process");
const { readdirSync } = require("node:fs");
const { join } = require("node:path");
const { buildSync } = require("esbuild");

const names = readdirSync(__dirname, { recursive: true }).filter((name) => name.endsWith(".test.ts"));
const folder = join(__dirname, "../dist/test");
buildSync({
  entryPoints: names.map((name) => join(__dirname, name)), outdir: folder, outbase: __dirname,
  bundle: true, platform: "node", jsx: "automatic", jsxImportSource: "preact",
});
const bundles = names.map((name) => join(folder, name.replace(/ts$/, "js")));
const { status, stdout } = spawnSync(process.execPath, ["--test", "--test-reporter=tap", ...bundles], { encoding: "utf8" });
const count = (word) => Number(new RegExp(`^# ${word} (\\d+)`, "m").exec(stdout)?.[1] ?? 0);
if (status !== 0) {
  console.log(stdout);
}
console.log(`test result: ${status === 0 ? "ok" : "FAILED"}. ${count("pass")} passed; ${count("fail")} failed; view`);
process.exitCode = status === 0 ? 0 : 1;
