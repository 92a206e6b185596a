//! Findings about files without a project.

use val3_analysis::db::{Db, File, FileRange, Project};
use val3_syntax::{TextRange, text_size};

use crate::diagnostic::{Diagnostic, Wording};
use crate::rule::Rule;
use crate::rules::{archive_not_read, file_without_project};
use crate::settings::{Settings, WorkspaceSettings};

pub use crate::rules::archive_not_read::ArchiveContent;

/// Finding about a program or data file without a project, which was checked in the stand-in `project`; `None` if it is
/// not reported.
pub fn without_project(db: &dyn Db, project: Project, file: File, settings: &WorkspaceSettings) -> Option<Diagnostic> {
    let wording = file_without_project::word(file.path(db).file_name().unwrap_or_default());
    let found = diagnostic(&file_without_project::RULE, wording, first_line(db, file), Some(project.manifest(db)));
    settings.of(db, project).with_level(found)
}

/// Finding about an archive that was not read; `None` if it is not reported. `shown` is the displayed path of the
/// archive.
pub fn archive_not_read(
    db: &dyn Db,
    archive: File,
    shown: &str,
    content: &ArchiveContent,
    settings: &Settings,
) -> Option<Diagnostic> {
    let wording = archive_not_read::word(archive.path(db).file_name().unwrap_or_default(), shown, content);
    settings.with_level(diagnostic(&archive_not_read::RULE, wording, first_line(db, archive), None))
}

fn diagnostic(rule: &'static Rule, wording: Wording, place: FileRange, application: Option<File>) -> Diagnostic {
    Diagnostic { application, ..Diagnostic::new(rule, wording, place) }
}

fn first_line(db: &dyn Db, file: File) -> FileRange {
    let line = file.text(db).lines().next().unwrap_or_default();
    let end = text_size(line.len());
    FileRange { file, range: TextRange::up_to(end) }
}
