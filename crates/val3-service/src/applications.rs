//! Applications and libraries by the names of the interface: `Disk://name/name.pjx`.

use val3_machine::controller::Controller;
use val3_machine::files::{ControllerPath, FileFault, LibraryPath};
use val3_soap::{ExceptionCode, SoapFault};
use val3_vm::{Instance, InstanceId};

use crate::context::refused;

/// Project that a request names.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(crate) enum NamedProject {
    /// Application or library in memory.
    Loaded(InstanceId),
    /// Project on `Disk`, with its name there.
    Stored(String),
}

/// Name of a loaded application or library.
pub(crate) fn project_name(instance: &Instance) -> String {
    // Paths of loaded projects are valid.
    let path = ControllerPath::parse(&instance.path, &ControllerPath::root(""));
    let project = path.and_then(|path| LibraryPath::new(&path)).map(|path| path.project().to_string());
    project.unwrap_or_else(|_| instance.path.clone())
}

/// Applications and libraries in memory, with their names.
pub(crate) fn loaded(controller: &Controller) -> impl Iterator<Item = (InstanceId, String)> {
    controller.vm.space.loaded().map(|(id, instance)| (id, project_name(instance)))
}

/// Names of the projects on `Disk`.
///
/// # Errors
/// The medium cannot be read.
pub(crate) fn stored(controller: &mut Controller) -> Result<Vec<String>, FileFault> {
    let projects = controller.devices.projects()?;
    Ok(projects.iter().map(|project| project.project().to_string()).collect())
}

/// Finds a project in memory or on `Disk`.
///
/// # Errors
/// There is no such project, or the medium cannot be read.
pub(crate) fn find(controller: &mut Controller, name: &str) -> Result<NamedProject, SoapFault> {
    if let Some((instance, _)) = loaded(controller).find(|(_, known)| known.eq_ignore_ascii_case(name)) {
        return Ok(NamedProject::Loaded(instance));
    }
    let stored = stored(controller).map_err(unreadable_medium)?;
    let project = stored.into_iter().find(|known| known.eq_ignore_ascii_case(name)).map(NamedProject::Stored);
    project.ok_or_else(|| refused(ExceptionCode::ApplicationNotFound, "getApplications lists the applications"))
}

/// Checks that a name is the name of the run's application, the only application that can be loaded and started.
///
/// # Errors
/// The name is another name.
pub(crate) fn check_application(controller: &Controller, name: &str) -> Result<(), SoapFault> {
    let application = controller.vm.space.instance(controller.application()).map(project_name).unwrap_or_default();
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
