//! Applications and libraries by the names of the interface: `Disk://name/name.pjx`.

use val3_bytecode::Image;
use val3_machine::controller::Controller;
use val3_machine::files::{ControllerPath, FileFault, LibraryPath};
use val3_vm::{Instance, InstanceId};

/// Name of a loaded application or library.
pub(crate) fn project_name(instance: &Instance) -> String {
    name_of_path(&instance.path)
}

/// Name of the project with this path in memory, such as `Disk://app`.
fn name_of_path(path: &str) -> String {
    // Paths of loaded projects are valid.
    let project = ControllerPath::parse(path, &ControllerPath::root("")).and_then(|path| LibraryPath::new(&path));
    project.map_or_else(|_| path.to_owned(), |project| project.project().to_string())
}

/// Name of the application after all pending loads, and its image.
pub(crate) fn next_application(controller: &Controller) -> (String, Option<&Image>) {
    let (path, image) = controller.next_application();
    (name_of_path(path), image)
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
