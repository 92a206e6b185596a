//! `dap`: generates the types of the Debug Adapter Protocol from its JSON schema.
//!
//! `typify` was not used: it does not support the schema's open enumerations (`_enum`), copies every description in the
//! specification into the code, and writes six times as many lines.

mod code;
mod schema;

use std::io::Write as _;
use std::process::{Command, Stdio};

use anyhow::{Context, bail};

use self::schema::Protocol;
use crate::project;

const SCHEMA: &str = "crates/val3-dap/schema/debugAdapterProtocol.json";
const FOLDER: &str = "crates/val3-dap/src/protocol";

/// A generated file.
pub struct GeneratedFile {
    /// Path relative to the project's folder.
    pub path: String,
    /// Formatted source.
    pub text: String,
}

/// Writes the types to `crates/val3-dap/src/protocol`.
///
/// # Errors
/// The schema uses a form that the generator does not support, or a file cannot be written.
pub fn run() -> anyhow::Result<()> {
    for GeneratedFile { path, text } in files()? {
        std::fs::write(project::root().join(&path), text).with_context(|| format!("cannot write {path}"))?;
        println!("{path}");
    }
    Ok(())
}

/// Returns all generated files, one for each kind of type.
///
/// # Errors
/// The schema uses a form that the generator does not support, or rustfmt fails.
pub fn files() -> anyhow::Result<Vec<GeneratedFile>> {
    let protocol = Protocol::read(&project::read(SCHEMA)?)?;
    let sources = code::sources(&protocol).into_iter();
    sources
        .map(|(name, source)| Ok(GeneratedFile { path: format!("{FOLDER}/{name}.rs"), text: format_source(&source)? }))
        .collect()
}

fn format_source(source: &str) -> anyhow::Result<String> {
    let mut rustfmt = Command::new("rustfmt");
    rustfmt.current_dir(project::root()).args(["--edition", "2024"]);
    rustfmt.stdin(Stdio::piped()).stdout(Stdio::piped());
    let mut child = rustfmt.spawn().context("cannot start rustfmt")?;
    // rustfmt reads the entire input before it writes.
    child.stdin.take().context("rustfmt has no input")?.write_all(source.as_bytes())?;
    let output = child.wait_with_output()?;
    if !output.status.success() {
        bail!("rustfmt ended with {}", output.status);
    }
    Ok(String::from_utf8(output.stdout)?)
}
