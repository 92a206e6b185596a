// Runs the grammar tests. VAL3_XML_GRAMMAR is the path of VS Code's XML grammar, which the grammars include.
const { spawnSync } = require("node:child_process");
const { readdirSync } = require("node:fs");
const { join } = require("node:path");

const TOOL = require.resolve("vscode-tmgrammar-test/dist/unit.js");
const xml = process.env.VAL3_XML_GRAMMAR;
if (xml === undefined) {
  throw new Error("VAL3_XML_GRAMMAR names no file");
}
const folder = join(__dirname, "grammar");
const grammars = ["val3-code", "val3"].flatMap((name) => ["-g", join(__dirname, `../syntaxes/${name}.tmLanguage.json`)]);
let failed = 0;
for (const file of readdirSync(folder)) {
  const { status, stdout, stderr } = spawnSync(process.execPath, [TOOL, ...grammars, "-g", xml, join(folder, file)], { encoding: "utf8" });
  if (status !== 0) {
    failed += 1;
    console.log(stdout, stderr);
  }
}
const passed = readdirSync(folder).length - failed;
console.log(`test result: ${failed === 0 ? "ok" : "FAILED"}. ${passed} passed; ${failed} failed; grammar`);
process.exitCode = failed === 0 ? 0 : 1;
