//! Lock against a second process that executes a pull or a push of the same project, or recovers a push.
//!
//! Two pulls would share the folder of downloaded files. A journal that is not complete belongs to a push that was
//! killed, or to one that is running. The system releases the lock of a killed process.

use val3_files::{ProcessLock, Unwritable};

use crate::error::ControllerError;
use crate::project::{ControllerProject, local};

/// Locked file in the folder of the backups, which is not part of a repository.
const NAME: &str = "lock";

/// Locks the pulls and pushes of a project until the value is dropped.
///
/// # Errors
/// If another process holds the lock, or the file cannot be created.
pub(crate) fn lock(project: &ControllerProject) -> Result<ProcessLock, ControllerError> {
    let area = project.area("backup");
    val3_files::create_folders(&area).map_err(|reason| local(&area, &reason))?;
    let path = area.join(NAME);
    ProcessLock::acquire(&path).map_err(|reason| match reason {
        Unwritable::Busy => ControllerError::Running,
        reason => local(&path, &reason),
    })
}
