// Bundles each page into one file of `dist`, including script and style.
const { mkdirSync, readFileSync, writeFileSync } = require("node:fs");
const { buildSync } = require("esbuild");

/** Packages that every page contains. Their licences require their notices. */
const COMMON = ["preact", "@preact/signals", "@preact/signals-core"];

/** Name in `dist`, title, entry point, additional packages. */
const PAGES = [
  ["view", "VAL 3", "src/main.tsx", ["three"]],
  ["data", "VAL 3 data", "src/data/main.tsx", []],
  ["variables", "Variables", "src/variables/main.tsx", []],
  ["history", "Values of a variable", "src/history/main.tsx", []],
];

function page([name, title, entry, packages]) {
  const { outputFiles, metafile } = buildSync({
    entryPoints: [entry],
    outdir: "dist",
    absWorkingDir: __dirname,
    bundle: true,
    minify: true,
    write: false,
    metafile: true,
    charset: "utf8",
    legalComments: "none",
    format: "iife",
    target: "es2023",
    jsx: "automatic",
    jsxImportSource: "preact",
  });
  const unnoticed = bundled(metafile).filter((name) => !packages.includes(name) && !COMMON.includes(name));
  if (unnoticed.length > 0) {
    throw new Error(`the page ${name} contains packages whose licences it does not have: ${unnoticed.join(", ")}`);
  }
  const text = (ending) => outputFiles.find(({ path }) => path.endsWith(ending))?.text.trim() ?? "";
  // A script ends at the first `</script`, even within a string.
  const script = text(".js").replaceAll("</script", "<\\/script");
  const licence = (name) => `${name}\n${readFileSync(`node_modules/${name}/LICENSE`, "utf8").trim()}`;
  const notices = [...packages, ...COMMON].map(licence).join("\n\n").replaceAll("--", "- -");
  writeFileSync(`dist/${name}.html`, `<!doctype html>
<!--
This page contains:

${notices}
-->
<html lang="en">
<head>
<meta charset="utf-8">
<meta name="viewport" content="width=device-width, initial-scale=1">
<title>${title}</title>
<style>${text(".css")}</style>
</head>
<body>
<script>${script}</script>
</body>
</html>
`);
}

/** Returns the packages that a bundle contains. */
function bundled({ inputs }) {
  const names = Object.keys(inputs).map((file) => /node_modules\/((?:@[^/]+\/)?[^/]+)\//.exec(file)?.[1]);
  return [...new Set(names)].filter((name) => name !== undefined);
}

process.chdir(__dirname);
mkdirSync("dist", { recursive: true });
PAGES.forEach(page);
