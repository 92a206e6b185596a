//! What editors know of the language without a server: grammars for colours, and the settings of the VS Code
//! extension. All of it comes from the catalogue; the files below `editors/` are never written by hand.

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

/// The manifest of the VS Code extension; of its values only the settings are generated.
const MANIFEST: &str = "editors/vscode/package.json";

/// A file made from the catalogue.
#[derive(Debug)]
pub struct GeneratedFile {
    /// Below the project's folder.
    pub path: &'static str,
    /// All of its text.
    pub text: String,
}

/// Every generated file of the project at `root`.
///
/// # Errors
/// If the manifest of the extension cannot be read or has no place for the settings.
pub fn generated(root: &Utf8Path) -> Result<Vec<GeneratedFile>> {
    let manifest = root.join(MANIFEST);
    let text = fs::read_to_string(&manifest).with_context(|| format!("reading {manifest}"))?;
    Ok(vec![
        json("editors/vscode/syntaxes/val3-code.tmLanguage.json", &grammar::code()),
        json("editors/vscode/syntaxes/val3.tmLanguage.json", &xml_grammar::program()),
        json("editors/vscode/syntaxes/val3-data.tmLanguage.json", &xml_grammar::data()),
        json("editors/vscode/syntaxes/val3-project.tmLanguage.json", &xml_grammar::project()),
        GeneratedFile { path: MANIFEST, text: manifest::with_settings(&text, &settings::all())? },
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
