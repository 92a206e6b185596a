//! `metrics`: size of the project, speed of `val3 check` on a large workspace, and speed of applications.

mod editor;
mod latency;
mod long_application;
pub mod running;
mod speed;

use std::collections::BTreeMap;

use crate::project;
use crate::tidy::files::{self, TextFile};

/// Options of `metrics`.
#[derive(clap::Args)]
pub struct Arguments {
    /// Code lines of the generated workspace that is checked
    #[arg(long, default_value_t = 100_000)]
    lines: usize,
    /// Only count the code
    #[arg(long)]
    no_speed: bool,
    /// Only measure how fast the language server answers
    #[arg(long)]
    lsp: bool,
    /// Only measure how fast applications run, against Lua and Python
    #[arg(long)]
    run: bool,
    /// Measure the packed binary that is there, without building it
    #[arg(long)]
    no_build: bool,
}

/// Prints the sizes, then the speed of the check and of the language server.
///
/// # Errors
/// A file cannot be read, or the build or the check fails.
pub fn run(arguments: &Arguments) -> anyhow::Result<()> {
    if !arguments.no_speed && !arguments.no_build {
        project::succeed(&mut project::cargo(&["build", "--profile", project::DIST, "--locked", "--package", "val3"]))?;
    }
    if arguments.lsp {
        return latency::measure(arguments.lines);
    }
    if arguments.run {
        return running::measure();
    }
    print_sizes(&files::all(&project::root())?);
    if arguments.no_speed {
        return Ok(());
    }
    speed::measure(arguments.lines)?;
    latency::measure(arguments.lines)
}

/// Hand-written lines of Rust.
#[derive(Debug, Default, Clone, Copy, PartialEq, Eq)]
struct Size {
    files: usize,
    lines: usize,
    tests: usize,
}

fn print_sizes(files: &[TextFile]) {
    let mut sizes: BTreeMap<String, Size> = BTreeMap::new();
    for file in files.iter().filter(|file| file.is_source()) {
        for owner in [owner(file), "all".to_owned()] {
            let size = sizes.entry(owner).or_default();
            size.files += 1;
            size.lines += file.text.lines().count();
            size.tests += file.text.lines().filter(|line| line.trim() == "#[test]").count();
        }
    }
    println!("{:16} {:>6} {:>8} {:>6}", "Rust", "files", "lines", "tests");
    for (owner, size) in sizes {
        println!("{owner:16} {:6} {:8} {:6}", size.files, size.lines, size.tests);
    }
}

/// Returns the crate to which a file belongs.
fn owner(file: &TextFile) -> String {
    let path = file.path.strip_prefix("crates").unwrap_or(&file.path);
    path.iter().next().unwrap_or_default().to_owned()
}
