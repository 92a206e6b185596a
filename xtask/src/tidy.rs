//! `tidy`: checks that a formatter does not perform, and a list of the largest files and functions.

mod faults;
pub(crate) mod files;
mod functions;

use anyhow::bail;

use self::files::TextFile;
use crate::project;

/// Number of listed files and functions.
const SHOWN: usize = 10;

/// Lists the largest files and functions, then all faults.
///
/// # Errors
/// There is a fault, or a file cannot be read.
pub fn run() -> anyhow::Result<()> {
    let files = files::all(&project::root())?;
    list_largest_files(&files);
    list_largest_functions(&files);
    let faults: Vec<_> = files.iter().flat_map(faults::of).collect();
    for fault in &faults {
        println!("{fault}");
    }
    match faults.len() {
        0 => Ok(()),
        count => bail!("untidy places: {count}"),
    }
}

fn list_largest_files(files: &[TextFile]) {
    let mut sources: Vec<_> = files.iter().filter(|file| file.is_source()).collect();
    sources.sort_by_key(|file| std::cmp::Reverse(file.text.lines().count()));
    println!("Largest files (lines)");
    for file in sources.iter().take(SHOWN) {
        println!("{:6}  {}", file.text.lines().count(), file.path);
    }
}

fn list_largest_functions(files: &[TextFile]) {
    let sources = files.iter().filter(|file| file.is_source());
    let mut functions: Vec<_> = sources.flat_map(functions::of).collect();
    functions.sort_by_key(|function| std::cmp::Reverse(function.lines));
    println!("Largest functions (lines)");
    for function in functions.iter().take(SHOWN) {
        println!("{:6}  {} {}:{}", function.lines, function.name, function.path, function.line);
    }
}
