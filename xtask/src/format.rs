//! `fmt`: formats every Rust file, including files that a macro declares, which `cargo fmt` does not find.

use std::process::Command;

use crate::project;
use crate::tidy::files;

/// Options of `fmt`.
#[derive(clap::Args)]
pub struct Arguments {
    /// Change nothing; fail where something is not formatted
    #[arg(long)]
    check: bool,
}

/// Formats the files, or checks that they are formatted.
///
/// # Errors
/// rustfmt cannot be started, or a file is not formatted.
pub fn run(arguments: &Arguments) -> anyhow::Result<()> {
    let root = project::root();
    let sources = files::all(&root)?;
    let rust = sources.iter().map(|file| file.path.as_str()).filter(|path| path.ends_with(".rs"));
    let mut rustfmt = Command::new("rustfmt");
    rustfmt.current_dir(&root).args(["--edition", "2024"]);
    if arguments.check {
        rustfmt.arg("--check");
    }
    project::succeed(rustfmt.args(rust))
}
