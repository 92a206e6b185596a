// Bundles the extension, and copies the files of the project that it contains.
const { cpSync, mkdirSync, readdirSync } = require("node:fs");
const { buildSync } = require("esbuild");

process.chdir(__dirname);
buildSync({
  entryPoints: ["src/extension.ts"],
  outfile: "dist/extension.js",
  bundle: true,
  minify: true,
  platform: "node",
  target: "node20",
  format: "cjs",
  external: ["vscode"],
});
mkdirSync("dist/schema", { recursive: true });
cpSync("../schema/val3.schema.json", "dist/schema/val3.schema.json");
for (const page of readdirSync("../view/dist").filter((name) => name.endsWith(".html"))) {
  cpSync(`../view/dist/${page}`, `dist/${page}`);
}
cpSync("../../LICENSE-MIT", "LICENSE.txt");
