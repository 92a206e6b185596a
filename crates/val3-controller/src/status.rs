//! Comparison of a project with its controller.

use crate::access::ControllerFiles;
use crate::address::ControllerAddress;
use crate::compare::{FileDifferences, compare};
use crate::digest::FileDigests;
use crate::error::ControllerError;
use crate::identity::ControllerIdentity;
use crate::identity_files::read_identity;
use crate::observer::TransferObserver;
use crate::path::ControllerPath;
use crate::project::ControllerProject;
use crate::scan::{StoreFile, check_applications, check_case, download, files_below};

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

    /// As [`read`](Self::read); passes each downloaded content to `store`.
    pub(crate) fn read_with(
        project: &ControllerProject,
        files: &mut dyn ControllerFiles,
        folders: &[ControllerPath],
        observer: &mut dyn TransferObserver,
        store: &mut StoreFile<'_>,
    ) -> Result<Self, ControllerError> {
        let paths = files_below(files, folders, observer)?;
        let controller = download(files, &paths, observer, store)?;
        // After the download, which can take minutes in which the user saves files.
        let local = project.local_files(folders)?;
        check_case(local.keys().chain(controller.keys()))?;
        let mut base = project.base();
        base.retain(|path, _| path.is_in_any(folders));
        let differences = compare(&base, &local, &controller);
        Ok(Self { local, controller, differences })
    }
}

/// Reads the controller's identity, and checks that it is the controller of the last pull. Without a serial number, the
/// address must equal the last pull's address.
///
/// # Errors
/// If the address has no folder of applications, or the identity cannot be read, or differs.
pub fn check_identity(
    project: &ControllerProject,
    address: &ControllerAddress,
    files: &mut dyn ControllerFiles,
    accepts_new: bool,
) -> Result<ControllerIdentity, ControllerError> {
    check_applications(files)?;
    let found = read_identity(files)?;
    let Some(state) = project.state.as_ref().filter(|_| !accepts_new) else { return Ok(found) };
    if state.controller.serial != found.serial {
        return Err(ControllerError::OtherController { expected: state.controller.clone(), found });
    }
    let is_same_place = || ControllerAddress::parse(&state.address).is_ok_and(|last| last.is_same_place(address));
    if found.serial.is_empty() && !is_same_place() {
        return Err(ControllerError::OtherAddress { expected: state.address.clone() });
    }
    Ok(found)
}
