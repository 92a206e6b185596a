//! Applications and libraries by the names of the interface: `Disk://name/name.pjx`.

use val3_machine::controller::Controller;
use val3_machine::files::{ControllerPath, FileFault, LibraryPath};
use val3_vm::{Instance, InstanceId};

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
