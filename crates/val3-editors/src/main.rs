//! `cargo run -p val3-editors`: writes the generated files in `editors/`.

use std::process::ExitCode;

use camino::Utf8Path;

fn main() -> ExitCode {
    let root = Utf8Path::new(env!("CARGO_MANIFEST_DIR")).join("../..");
    match val3_editors::write(&root) {
        Ok(()) => ExitCode::SUCCESS,
        Err(error) => {
            eprintln!("error: {error:#}");
            ExitCode::FAILURE
        }
    }
}
