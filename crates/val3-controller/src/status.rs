//! Comparison of a project with its controller.

use crate::access::ControllerFiles;
use crate::compare::{FileDifferences, compare};
use crate::digest::FileDigests;
use crate::error::ControllerError;
use crate::identity::ControllerIdentity;
use crate::identity_files::read_identity;
use crate::observer::TransferObserver;
use crate::path::ControllerPath;
use crate::project::ControllerProject;
use crate::scan::{StoreFile, check_case, download, files_below};

/// Files of both sides, compared with the last pull or push.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct ProjectStatus {
    /// Local files.
    pub local: FileDigests,
    /// Files on the controller.
    pub controller: FileDigests,
    /// Files with a difference.
    pub differences: FileDifferences,
}

impl ProjectStatus {
    /// Downloads all files in the folders, and compares their contents.
    ///
    /// # Errors
    /// If a file of either side cannot be read.
    pub fn read(
        project: &ControllerProject,
        files: &mut dyn ControllerFiles,
        folders: &[ControllerPath],
        observer: &mut dyn TransferObserver,
    ) -> Result<Self, ControllerError> {
        Self::read_with(project, files, folders, observer, &mut |_, _| Ok(()))
    }

    /// As [`read`](Self::read); passes the content of each file on the controller to `store`.
    pub(crate) fn read_with(
        project: &ControllerProject,
        files: &mut dyn ControllerFiles,
        folders: &[ControllerPath],
        observer: &mut dyn TransferObserver,
        store: &mut StoreFile<'_>,
    ) -> Result<Self, ControllerError> {
        let local = project.local_files(folders)?;
        let paths = files_below(files, folders, observer)?;
        let controller = download(files, &paths, observer, store)?;
        check_case(local.keys().chain(controller.keys()))?;
        let mut base = project.base();
        base.retain(|path, _| folders.iter().any(|folder| path.is_in(folder)));
        let differences = compare(&base, &local, &controller);
        Ok(Self { local, controller, differences })
    }
}

/// Reads the controller's identity, and checks that it is the controller of the last pull.
///
/// # Errors
/// If the identity cannot be read, or differs.
pub fn check_identity(
    project: &ControllerProject,
    files: &mut dyn ControllerFiles,
    accepts_new: bool,
) -> Result<ControllerIdentity, ControllerError> {
    let found = read_identity(files)?;
    match &project.state {
        Some(state) if state.controller.serial != found.serial && !accepts_new => {
            Err(ControllerError::OtherController { expected: state.controller.clone(), found })
        }
        _ => Ok(found),
    }
}
