//! `cargo run -p val3-book`: builds the book and prints the path of its first page.

use std::process::ExitCode;

use camino::Utf8Path;

fn main() -> ExitCode {
    let root = Utf8Path::new(env!("CARGO_MANIFEST_DIR")).join("../..");
    match val3_book::build(&root) {
        Ok(folder) => {
            println!("{folder}/index.html");
            ExitCode::SUCCESS
        }
        Err(error) => {
            eprintln!("error: {error:#}");
            ExitCode::FAILURE
        }
    }
}
