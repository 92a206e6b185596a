//! The project that takes the place of a missing one for a single program or data file.

use camino::{Utf8Path, Utf8PathBuf};
use val3_analysis::items::unlisted::is_program;
use val3_analysis::system::System;
use val3_files::FileClass;

/// Bytes of a file within which its root element begins.
const HEAD: usize = 4_096;

/// Root elements of files of s5 and s6.
const OLD_ROOTS: [&[u8]; 2] = [b"<programList", b"<dataList"];

/// The path of the project file. No disk contains it, because its folder contains no project file.
pub(super) fn path(file: &Utf8Path) -> Utf8PathBuf {
    format!("{file}.pjx").into()
}

/// The version that a file of s7 or s8 is checked for, which has the fewest limits: the file does not name its own.
const VERSION: &str = "s8.20";

/// A project file with one program or data file. Its unknown element makes the project incomplete, so that unknown names
/// are no faults.
pub(super) fn project(system: &dyn System, file: &Utf8Path) -> String {
    let name = file.file_name().unwrap_or_default().replace('&', "&amp;").replace('<', "&lt;").replace('"', "&quot;");
    // A file that cannot be read is reported for what it is.
    let bytes = system.read(file, FileClass::Program).unwrap_or_default();
    let head = bytes.get(..HEAD).unwrap_or(&bytes);
    let is_old = OLD_ROOTS.iter().any(|root| head.windows(root.len()).any(|window| window == *root));
    let (list, entry) = match (is_old, is_program(file.as_str())) {
        (true, true) => ("programSection", "program"),
        (true, false) => ("dataSection", "data"),
        (false, true) => ("Programs", "Program"),
        (false, false) => ("Database", "Data"),
    };
    let listed = format!("<{list}><{entry} file=\"{name}\" /></{list}>");
    match is_old {
        true => format!("<project>{listed}<unknown /></project>\n"),
        false => format!(
            "<Project xmlns=\"http://www.staubli.com/robotics/VAL3/Project/3\"><Parameters version=\"{VERSION}\" />\
             {listed}<Unknown /></Project>\n"
        ),
    }
}
