//! The files of a controller, compared with local ones.

use camino::Utf8Path;
use val3_controller::{ControllerPath, ControllerProject, check_applications, read_files};
use val3_diff::FileTree;

use super::compared_versions::ComparedVersions;
use super::folder;
use crate::args::ConnectionArgs;
use crate::controller::{ControllerTarget, ProgressObserver, parse_address, project_folder, shown};
use crate::user_error::UserError;

/// Reads the files of a controller, and the files in the same folders here.
///
/// The folders are those of the last pull, or all applications. A push that was killed is not recovered.
pub(super) fn versions(
    address: &Utf8Path,
    local: Option<&Utf8Path>,
    connection: &ConnectionArgs,
) -> Result<ComparedVersions, UserError> {
    let address = parse_address(address.as_str())?;
    let project = ControllerProject::open(&project_folder(local)?)?;
    let mut target = ControllerTarget::new(address, connection, project.state.as_ref())?;
    let folders = match &project.state {
        Some(state) => state.folders.clone(),
        None => vec![ControllerPath::applications()],
    };
    let local = project.local_files(&folders)?;
    let at = shown(project.folder())?;
    if local.is_empty() {
        return Err(UserError::new(format!("`{at}` contains no files of a controller"))
            .with_help("name the folder that contains `usr/usrapp`: `val3 diff ftp://PROFILE@HOST DIR`"));
    }
    let mut observer = ProgressObserver::default();
    let mut files = target.connect()?;
    check_applications(&mut *files)?;
    let remote = read_files(&mut *files, &folders, &mut observer)?;
    observer.end();
    let old = remote.into_iter().map(|(path, bytes)| (path.as_str().to_owned(), bytes));
    let mut new = Vec::new();
    for path in local.keys() {
        let at = project.local(path);
        new.push((path.as_str().to_owned(), folder::read(&at, at.as_str())?));
    }
    Ok(ComparedVersions { trees: [FileTree::new(old), FileTree::new(new)], names: [target.address.to_string(), at] })
}
