// Bundles the extension, and copies the project files that it contains.
const { cpSync, mkdirSync, readFileSync, readdirSync, writeFileSync } = require("node:fs");
const { buildSync } = require("esbuild");

process.chdir(__dirname);
const { metafile } = buildSync({
  entryPoints: ["src/extension.ts"],
  outfile: "dist/extension.js",
  bundle: true,
  minify: true,
  platform: "node",
  target: "node20",
  format: "cjs",
  external: ["vscode"],
  legalComments: "linked",
  metafile: true,
});
writeFileSync("dist/notices.txt", notices(Object.keys(metafile.inputs)));
mkdirSync("dist/schema", { recursive: true });
cpSync("../schema/val3.schema.json", "dist/schema/val3.schema.json");
for (const page of readdirSync("../view/dist").filter((name) => name.endsWith(".html"))) {
  cpSync(`../view/dist/${page}`, `dist/${page}`);
}
cpSync("../../CHANGELOG.md", "CHANGELOG.md");
const licences = ["MIT", "APACHE"].map((name) => readFileSync(`../../LICENSE-${name}`, "utf8"));
writeFileSync("LICENSE.txt", `MIT OR Apache-2.0, at your choice.\n\n${licences.join("\n\n")}`);

/** Returns the licence texts of the packages that a bundle contains. */
function notices(inputs) {
  const folders = inputs.map((file) => /^(.*node_modules\/(?:@[^/]+\/)?[^/]+)\//.exec(file)?.[1]);
  return [...new Set(folders)].filter((folder) => folder !== undefined).sort().map(notice).join("");
}

function notice(folder) {
  const { name, version } = JSON.parse(readFileSync(`${folder}/package.json`, "utf8"));
  const files = readdirSync(folder).filter((file) => /^(licen[cs]e|copying|notice|thirdparty)/i.test(file));
  if (files.length === 0) {
    throw new Error(`${name} ${version}, a package of the extension, has no licence text`);
  }
  const rule = "-".repeat(80);
  const texts = files.map((file) => readFileSync(`${folder}/${file}`, "utf8").replaceAll("\r\n", "\n").trim());
  return `\n${rule}\n${name} ${version} (npm)\n${rule}\n\n${texts.join("\n\n")}\n`;
}
