//! Generates the files in `editors/` that describe the language: the grammars for syntax colouring, and the settings
//! and launch configurations in the manifest of the VS Code extension. They derive from the catalogue, the rules and
//! the debugger's schema, and are never edited by hand.

mod debugger;
mod grammar;
mod manifest;
mod settings;
pub mod typescript;
mod wire;
mod words;
mod xml_grammar;

use anyhow::{Context as _, Result};
use camino::Utf8Path;
use serde_json::Value;

use crate::files;

/// Manifest of the VS Code extension. Only its settings, debugger, version, address and publisher are generated.
const MANIFEST: &str = "editors/vscode/package.json";
/// Output of `val3 schema --debugger`.
const DEBUGGER_SCHEMA: &str = "editors/schema/debugger.schema.json";

/// A generated file.
#[derive(Debug)]
pub struct GeneratedFile {
    /// Path relative to the project's folder.
    pub path: &'static str,
    /// Complete content.
    pub text: String,
}

/// Returns all generated files of the project at `root`.
///
/// # Errors
/// The manifest of the extension cannot be read, or does not contain a generated value.
pub fn generated(root: &Utf8Path) -> Result<Vec<GeneratedFile>> {
    let schema = serde_json::from_str(&files::read(&root.join(DEBUGGER_SCHEMA))?)
        .with_context(|| format!("reading {DEBUGGER_SCHEMA}"))?;
    let manifest = manifest::with_list(&files::read(&root.join(MANIFEST))?, "configuration", &settings::all())?;
    let manifest = manifest::with_list(&manifest, "debuggers", &debugger::all(&schema))?;
    let manifest = manifest::with_origin(&manifest)?;
    let mut files = vec![
        json("editors/vscode/syntaxes/val3-code.tmLanguage.json", &grammar::code()),
        json("editors/vscode/syntaxes/val3.tmLanguage.json", &xml_grammar::program()),
        json("editors/vscode/syntaxes/val3-data.tmLanguage.json", &xml_grammar::data()),
        json("editors/vscode/syntaxes/val3-project.tmLanguage.json", &xml_grammar::project()),
        GeneratedFile { path: MANIFEST, text: manifest },
    ];
    files.extend(wire::view_messages()?);
    files.extend(wire::debug_requests()?);
    files.extend(wire::server_requests()?);
    Ok(files)
}

/// Writes all generated files of the project at `root`.
///
/// # Errors
/// A file cannot be read or written.
pub fn write(root: &Utf8Path) -> Result<()> {
    for file in generated(root)? {
        files::write(&root.join(file.path), &file.text)?;
    }
    Ok(())
}

fn json(path: &'static str, value: &Value) -> GeneratedFile {
    GeneratedFile { path, text: format!("{value:#}\n") }
}
