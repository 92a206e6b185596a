//! `cargo run -p val3-generate editors` writes the generated files in `editors/`. `cargo run -p val3-generate book` builds
//! the book and prints the path of its first page.

#![allow(clippy::disallowed_methods, reason = "a tool of the project, not a part of the product")]

use std::process::ExitCode;

use anyhow::{Result, bail};
use camino::Utf8Path;

fn main() -> ExitCode {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    match generate(&arguments) {
        Ok(()) => ExitCode::SUCCESS,
        Err(error) => {
            eprintln!("error: {error:#}");
            ExitCode::FAILURE
        }
    }
}

/// Generates the named output.
///
/// # Errors
/// The arguments are not one known name, or the output cannot be generated.
fn generate(arguments: &[String]) -> Result<()> {
    let root = Utf8Path::new(env!("CARGO_MANIFEST_DIR")).join("../..");
    let names: Vec<_> = arguments.iter().map(String::as_str).collect();
    match names[..] {
        ["book"] => {
            let folder = val3_generate::book::build(&root)?;
            println!("{folder}/index.html");
            Ok(())
        }
        ["editors"] => val3_generate::editors::write(&root),
        _ => bail!("expected `book` or `editors`"),
    }
}
