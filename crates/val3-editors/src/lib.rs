//! Generates the files of `editors/` that describe the language: the grammars for syntax colouring, and the settings in the
//! manifest of the VS Code extension. They derive from the catalogue and the rules and are never edited by hand.

#![allow(clippy::disallowed_methods, reason = "a tool of the project, not a part of the product")]

mod grammar;
mod manifest;
mod settings;
mod words;
mod xml_grammar;

use std::fs;

use anyhow::{Context as _, Result};
use camino::Utf8Path;
use serde_json::Value;

/// The manifest of the VS Code extension. Only its settings, version, address and publisher are generated.
const MANIFEST: &str = "editors/vscode/package.json";

/// A generated file.
#[derive(Debug)]
pub struct GeneratedFile {
    /// Relative to the project's folder.
    pub path: &'static str,
    /// The whole text.
    pub text: String,
}

/// Every generated file of the project at `root`.
///
/// # Errors
/// If the manifest of the extension cannot be read or lacks a generated value.
pub fn generated(root: &Utf8Path) -> Result<Vec<GeneratedFile>> {
    let path = root.join(MANIFEST);
    let text = fs::read_to_string(&path).with_context(|| format!("reading {path}"))?;
    let manifest = manifest::with_origin(&manifest::with_settings(&text, &settings::all())?)?;
    Ok(vec![
        json("editors/vscode/syntaxes/val3-code.tmLanguage.json", &grammar::code()),
        json("editors/vscode/syntaxes/val3.tmLanguage.json", &xml_grammar::program()),
        json("editors/vscode/syntaxes/val3-data.tmLanguage.json", &xml_grammar::data()),
        json("editors/vscode/syntaxes/val3-project.tmLanguage.json", &xml_grammar::project()),
        GeneratedFile { path: MANIFEST, text: manifest },
    ])
}

/// Writes every generated file of the project at `root`.
///
/// # Errors
/// If a file cannot be read or written.
pub fn write(root: &Utf8Path) -> Result<()> {
    for file in generated(root)? {
        let path = root.join(file.path);
        fs::write(&path, file.text).with_context(|| format!("writing {path}"))?;
    }
    Ok(())
}

fn json(path: &'static str, value: &Value) -> GeneratedFile {
    GeneratedFile { path, text: format!("{value:#}\n") }
}
