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
    let stored = applications::stored(controller).map_err(unreadable_medium)?;
    let project = stored.into_iter().find(|known| known.eq_ignore_ascii_case(name)).map(NamedProject::Stored);
    project.ok_or_else(|| refused(ExceptionCode::ApplicationNotFound, "getApplications lists the applications"))
}

/// Checks that a name is the name of the run's application, the only application that can be loaded and started.
///
/// # Errors
/// The name is another name.
pub(crate) fn check_application(controller: &Controller, name: &str) -> Result<(), SoapFault> {
    let application =
        controller.vm.space.instance(controller.application()).map(applications::project_name).unwrap_or_default();
    if application.eq_ignore_ascii_case(name) {
        return Ok(());
    }
    let explanation = format!("this controller executes only the application of the run, {application}");
    Err(refused(ExceptionCode::ApplicationNotFound, &explanation))
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
