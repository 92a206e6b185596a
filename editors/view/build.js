// Bundles the page into one file: dist/view.html, with script and style inside.
const { mkdirSync, readFileSync, writeFileSync } = require("node:fs");
const { buildSync } = require("esbuild");

process.chdir(__dirname);
const { outputFiles } = buildSync({
  entryPoints: ["src/main.tsx"],
  outdir: "dist",
  absWorkingDir: __dirname,
  bundle: true,
  minify: true,
  write: false,
  charset: "utf8",
  legalComments: "none",
  format: "iife",
  target: "es2023",
  jsx: "automatic",
  jsxImportSource: "preact",
});
const text = (ending) => outputFiles.find(({ path }) => path.endsWith(ending))?.text.trim() ?? "";
// A script ends at the first `</script`, even within a text.
const script = text(".js").replaceAll("</script", "<\\/script");
// The licences of the packages inside ask for their notices.
const licence = (name) => `${name}\n${readFileSync(`node_modules/${name}/LICENSE`, "utf8").trim()}`;
const notices = ["three", "preact", "@preact/signals", "@preact/signals-core"].map(licence).join("\n\n").replaceAll("--", "- -");
mkdirSync("dist", { recursive: true });
writeFileSync("dist/view.html", `<!doctype html>
<!--
This page contains:

${notices}
-->
<html lang="en">
<head>
<meta charset="utf-8">
<meta name="viewport" content="width=device-width, initial-scale=1">
<title>VAL 3</title>
<style>${text(".css")}</style>
</head>
<body>
<script>${script}</script>
</body>
</html>
`);
