// Bundles the page into one file: dist/view.html, with script and style inside.
const { mkdirSync, writeFileSync } = require("node:fs");
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
mkdirSync("dist", { recursive: true });
writeFileSync("dist/view.html", `<!doctype html>
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
