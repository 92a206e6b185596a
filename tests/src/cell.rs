//! Cells in `examples/`.

use std::fs;
use std::path::{Path, PathBuf};

/// Files of a cell: path relative to the controller's folder (`usr/usrapp/…`, `/` as separator) and bytes.
pub type Cell = Vec<(String, Vec<u8>)>;

/// Folder with the applications of a cell.
pub const APPLICATIONS: &str = "usr/usrapp/";

/// Reads the files of the controller in `examples/NAME/usr`, sorted by path.
///
/// # Panics
/// The cell or a file in it cannot be read.
#[track_caller]
pub fn files(name: &str) -> Cell {
    let root = examples().join(name);
    let mut files = Vec::new();
    collect(&root, &root.join("usr"), &mut files);
    files.sort();
    files
}

/// Returns the location of the only line in `file` (below [`APPLICATIONS`]) that contains `text`: path and line, from
/// 1.
///
/// # Errors
/// The file or line does not exist, or several lines contain the text.
pub fn place_of(cell: &Cell, file: &str, text: &str) -> Result<(String, usize), String> {
    let path = format!("{APPLICATIONS}{file}");
    let content = text_of(cell, &path)?;
    let mut lines = (1..).zip(content.lines()).filter(|(_, line)| line.contains(text)).map(|(number, _)| number);
    match (lines.next(), lines.next()) {
        (Some(line), None) => Ok((path, line)),
        (None, _) => Err(format!("{text:?} is not in {file}")),
        (Some(_), Some(_)) => Err(format!("{text:?} is in {file} twice")),
    }
}

/// Returns the text of the file at `path`, with its byte order mark.
///
/// # Errors
/// The file does not exist, or is not in UTF-8.
pub fn text_of(cell: &Cell, path: &str) -> Result<String, String> {
    let (_, bytes) = cell.iter().find(|(known, _)| known == path).ok_or_else(|| format!("no file {path}"))?;
    String::from_utf8(bytes.clone()).map_err(|error| error.to_string())
}

/// Returns the folder of the example cells.
pub fn examples() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../examples")
}

#[track_caller]
fn collect(root: &Path, folder: &Path, files: &mut Cell) {
    let entries = fs::read_dir(folder).unwrap_or_else(|error| panic!("{}: {error}", folder.display()));
    for path in entries.filter_map(Result::ok).map(|entry| entry.path()) {
        if path.is_dir() {
            collect(root, &path, files);
        } else {
            let bytes = fs::read(&path).unwrap_or_else(|error| panic!("{}: {error}", path.display()));
            files.push((relative(root, &path), bytes));
        }
    }
}

fn relative(root: &Path, path: &Path) -> String {
    let inside = path.strip_prefix(root).unwrap_or(path);
    inside.components().map(|part| part.as_os_str().to_string_lossy()).collect::<Vec<_>>().join("/")
}
