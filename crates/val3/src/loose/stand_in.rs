//! Stand-in project for a single program or data file without a project.

use camino::{Utf8Path, Utf8PathBuf};
use val3_analysis::items::unlisted::is_program;
use val3_analysis::system::System;
use val3_files::FileClass;

/// Number of bytes in which the root element of a file begins.
const HEAD: usize = 4_096;

/// Root elements of s5 and s6 files.
const OLD_ROOTS: [&[u8]; 2] = [b"<programList", b"<dataList"];

/// Path of the stand-in project file. The disk does not contain it, because the folder contains no project file.
pub(super) fn path(file: &Utf8Path) -> Utf8PathBuf {
    format!("{file}.pjx").into()
}

/// Assumed version of s7 and s8 files, because the file does not state one. s8.20 has the fewest restrictions.
const VERSION: &str = "s8.20";

/// Text of a project file with one program or data file. The unknown element marks the project as incomplete, so that
/// unresolved names are no faults.
pub(super) fn project(system: &dyn System, file: &Utf8Path) -> String {
    let name = file.file_name().unwrap_or_default().replace('&', "&amp;").replace('<', "&lt;").replace('"', "&quot;");
    // A file that cannot be read is reported elsewhere.
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
