//! `codegen`: the typed syntax tree, from the grammar.
//!
//! A grammar rule becomes a struct with an accessor for each part, or an enum where the rule is a choice of rules.
//! [`model`] says what is generated for a rule; [`render`] writes it down.

mod grammar;
mod model;
mod names;
mod render;
mod tokens;

use std::io::Write as _;
use std::process::{Command, Stdio};

use anyhow::{Context, bail};

use crate::project;

const GRAMMAR: &str = "crates/val3-syntax/val3.ungram";
const GENERATED: &str = "crates/val3-syntax/src/ast/generated.rs";

/// Options of `codegen`.
#[derive(clap::Args)]
pub struct Arguments {
    /// Write nothing; fail when the file differs from what would be written
    #[arg(long)]
    check: bool,
}

/// Writes the file, or compares it.
///
/// # Errors
/// When the grammar is wrong, a file cannot be read or written, or the comparison finds a difference.
pub fn run(arguments: &Arguments) -> anyhow::Result<()> {
    let wanted = generate(&project::read(GRAMMAR)?)?;
    if arguments.check {
        return compare(&wanted, &project::read(GENERATED)?);
    }
    let path = project::root().join(GENERATED);
    std::fs::write(&path, wanted).with_context(|| format!("cannot write {path}"))
}

/// The formatted source text for a grammar.
///
/// # Errors
/// When the grammar is wrong or rustfmt fails.
pub fn generate(grammar: &str) -> anyhow::Result<String> {
    let source = grammar::Source::parse(grammar)?;
    let model = model::Model::of(&source)?;
    format(&render::render(&model, &source))
}

fn compare(wanted: &str, found: &str) -> anyhow::Result<()> {
    let Some(line) = first_difference(wanted, found) else {
        return Ok(());
    };
    let at = |text: &str| text.lines().nth(line).unwrap_or("(end of file)").to_owned();
    bail!(
        "{GENERATED} is not what {GRAMMAR} gives; run `cargo xtask codegen`\n\
         line {}\n  in the file:      {}\n  from the grammar: {}",
        line + 1,
        at(found),
        at(wanted),
    )
}

/// The first line that differs, from 0.
fn first_difference(left: &str, right: &str) -> Option<usize> {
    if left == right {
        return None;
    }
    let equal = left.lines().zip(right.lines()).take_while(|(l, r)| l == r);
    Some(equal.count())
}

fn format(source: &str) -> anyhow::Result<String> {
    let mut rustfmt = Command::new("rustfmt")
        .args(["--edition", "2024", "--emit", "stdout"])
        .current_dir(project::root())
        .stdin(Stdio::piped())
        .stdout(Stdio::piped())
        .spawn()
        .context("cannot start rustfmt")?;
    // Dropped at the end of the statement, so that rustfmt sees the end of its input.
    rustfmt.stdin.take().context("rustfmt takes no input")?.write_all(source.as_bytes())?;
    let output = rustfmt.wait_with_output()?;
    if !output.status.success() {
        bail!("rustfmt refuses the generated source:\n{source}");
    }
    Ok(String::from_utf8(output.stdout)?)
}

#[cfg(test)]
mod tests;
