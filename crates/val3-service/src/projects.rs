//! Projects that requests name, and faults about them.

use val3_machine::controller::Controller;
use val3_machine::files::FileFault;
use val3_soap::{ExceptionCode, SoapFault};
use val3_vm::InstanceId;

use crate::applications;
use crate::context::refused;

/// Project that a request names.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(crate) enum NamedProject {
    /// Application or library in memory.
    Loaded(InstanceId),
    /// Project on `Disk`, with its name there.
    Stored(String),
}

/// Finds a project in memory or on `Disk`.
///
/// # Errors
/// There is no such project, or the medium cannot be read.
pub(crate) fn find(controller: &mut Controller, name: &str) -> Result<NamedProject, SoapFault> {
    if let Some((instance, _)) = applications::loaded(controller).find(|(_, known)| known.eq_ignore_ascii_case(name)) {
        return Ok(NamedProject::Loaded(instance));
    }
    find_stored(controller, name).map(NamedProject::Stored)
}

/// Finds a project on `Disk`. Returns its name there.
///
/// # Errors
/// There is no such project, or the medium cannot be read.
pub(crate) fn find_stored(controller: &mut Controller, name: &str) -> Result<String, SoapFault> {
    let stored = applications::stored(controller).map_err(unreadable_medium)?;
    let project = stored.into_iter().find(|known| known.eq_ignore_ascii_case(name));
    project.ok_or_else(|| refused(ExceptionCode::ApplicationNotFound, "getApplications lists the applications"))
}

/// Fault for a medium that cannot be read.
pub(crate) fn unreadable_medium(_: FileFault) -> SoapFault {
    refused(ExceptionCode::FileNotFound, "the medium Disk cannot be read")
}

/// Fault for files of a project that cannot be read. `files` is their description.
pub(crate) fn unreadable_project(files: &str, fault: FileFault) -> SoapFault {
    match fault {
        FileFault::ReadOnly => refused(ExceptionCode::ReadAccess, "the project is encrypted"),
        FileFault::NotFound => refused(ExceptionCode::FileNotFound, &format!("the project has no {files}")),
        other => {
            let explanation = format!("the {files} cannot be read (error {} of libLoad)", other.code());
            refused(ExceptionCode::FileNotFound, &explanation)
        }
    }
}
