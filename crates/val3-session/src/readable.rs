//! Readability of an application's files, including loaded projects and the cell.

use val3_analysis::db::{Db, File, FileStatus, Project, Sources};
use val3_analysis::items::faults::text_faults;
use val3_analysis::items::project::{data_files, program_files};
use val3_syntax::document;

use crate::error::SessionError;

/// Checks that all files of the application, its loaded projects and its cell were read. Without them, the run would
/// differ from a run on a controller.
///
/// # Errors
/// The first unreadable file, with the reason.
pub(crate) fn check(db: &dyn Db, application: Project) -> Result<(), SessionError> {
    check_cell(db, application)?;
    let mut projects: Vec<(&String, &Project)> = Sources::get(db).projects(db).iter().collect();
    projects.sort_unstable_by_key(|(key, _)| *key);
    for (_, project) in projects {
        check_file(db, project.manifest(db))?;
        let files = program_files(db, *project).iter().chain(data_files(db, *project));
        files.copied().try_for_each(|file| check_file(db, file))?;
    }
    Ok(())
}

fn check_file(db: &dyn Db, file: File) -> Result<(), SessionError> {
    let reason = match file.status(db) {
        FileStatus::Unreadable(reason) => Some(reason.clone()),
        _ => document::fault(file.text(db), &text_faults(db, file).errors).map(|fault| fault.to_string()),
    };
    reason.map_or(Ok(()), |reason| Err(SessionError::UnreadableFile { file: file.path(db).clone(), reason }))
}

fn check_cell(db: &dyn Db, project: Project) -> Result<(), SessionError> {
    let unreadable = project.cell(db).and_then(|cell| cell.config(db).unreadable_files.first());
    let usr = project.disk(db).and_then(|disk| disk.parent());
    match unreadable.zip(usr) {
        Some((file, usr)) => {
            let (file, reason) = (usr.join(file.path.as_str()), file.reason.to_string());
            Err(SessionError::UnreadableFile { file, reason })
        }
        None => Ok(()),
    }
}
