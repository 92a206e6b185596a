//! Requested files that are not on the disk in this form: those of archives, and projects of programs without one.

use std::collections::BTreeSet;

use camino::{Utf8Path, Utf8PathBuf};
use val3_analysis::items::unlisted::is_program;
use val3_analysis::load::LoadError;
use val3_analysis::paths::normalise;
use val3_analysis::system::{Disk, OverlayFs, System};
use val3_files::{is_archive_name, read_head, unpack};

use crate::paths::Paths;

/// Extensions of the files of a cell that a check reads.
const EXTENSIONS: [&str; 9] = ["pjx", "pgx", "dtx", "cfx", "cf", "xml", "toml", "json", "html"];

/// The root element of a program of s5 and s6.
const OLD_ROOT: &[u8] = b"<programList";

/// Bytes of a program within which its root element begins.
const HEAD: u64 = 4_096;

/// Lays the files of the requested archives, and projects for requested programs without one, over a file system.
///
/// # Errors
/// An archive cannot be read.
pub(crate) fn add<S: System>(system: &mut OverlayFs<S>, asked: &[Utf8PathBuf]) -> Result<(), LoadError> {
    let asked: Vec<Utf8PathBuf> = asked.iter().map(|path| normalise(path)).collect();
    let archives: BTreeSet<&Utf8Path> = asked.iter().filter_map(|path| archive_around(path)).collect();
    for archive in archives {
        let files = unpack(archive, is_of_cell).map_err(|fault| LoadError::Path {
            path: archive.to_owned(),
            reason: format!("the archive cannot be read: {fault}"),
        })?;
        files.into_iter().for_each(|(path, bytes)| system.store(archive.join(path), bytes));
    }
    for program in asked.iter().filter(|path| is_lone_program(path)) {
        system.store(program.with_extension("pjx"), project_of(program).into_bytes());
    }
    Ok(())
}

/// The archive that a path names, or in which it lies.
pub(crate) fn archive_around(path: &Utf8Path) -> Option<&Utf8Path> {
    path.ancestors().find(|path| is_archive_name(path) && path.is_file())
}

/// States which requested programs have no project; `None` if all have one.
pub(crate) fn notice(asked: &[Utf8PathBuf], paths: &Paths) -> Option<String> {
    let lone = asked.iter().map(|path| normalise(path)).filter(|path| is_lone_program(path));
    let shown: Vec<String> = lone.map(|path| format!("`{}`", paths.shown(&path))).collect();
    let verb = if shown.len() == 1 { "has" } else { "have" };
    (!shown.is_empty()).then(|| {
        format!(
            "{} {verb} no project (`.pjx`) in the folder: names and types that the project declares are not checked",
            shown.join(", ")
        )
    })
}

fn is_of_cell(path: &Utf8Path) -> bool {
    let is = |known: &str| path.extension().is_some_and(|extension| extension.eq_ignore_ascii_case(known));
    EXTENSIONS.iter().any(|known| is(known))
}

/// Whether a path is that of a program without a project in its folder.
fn is_lone_program(path: &Utf8Path) -> bool {
    let is_project = |name: &String| Utf8Path::new(name).extension().is_some_and(|it| it.eq_ignore_ascii_case("pjx"));
    let names = || path.parent().and_then(|folder| Disk.list(folder).ok()).unwrap_or_default();
    is_program(path.as_str()) && path.is_file() && !names().iter().any(is_project)
}

/// A project file with the program. Its unknown element makes the project incomplete, so that unknown names are no faults.
fn project_of(program: &Utf8Path) -> String {
    let name =
        program.file_name().unwrap_or_default().replace('&', "&amp;").replace('<', "&lt;").replace('"', "&quot;");
    // A program that cannot be read is reported for what it is.
    let head = read_head(program, HEAD).unwrap_or_default();
    let is_old = head.windows(OLD_ROOT.len()).any(|window| window == OLD_ROOT);
    match is_old {
        true => format!("<project><programSection><program file=\"{name}\" /></programSection><unknown /></project>\n"),
        false => format!(
            "<Project xmlns=\"http://www.staubli.com/robotics/VAL3/Project/3\">\n  <Programs>\n    \
             <Program file=\"{name}\" />\n  </Programs>\n  <Unknown />\n</Project>\n"
        ),
    }
}
