//! Arguments of a pull.

use crate::connection_settings::ConnectionSettings;
use crate::identity::ControllerIdentity;
use crate::path::ControllerPath;

/// Versions of a file that both sides have changed.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct ConflictVersions {
    /// Content at the last pull; empty if both sides have added the file. `None` if this content is not stored,
    /// for example in a clone of the project; then the changes of each side are unknown.
    pub base: Option<Vec<u8>>,
    /// Local content.
    pub local: Vec<u8>,
    /// Content on the controller.
    pub controller: Vec<u8>,
}

/// Merges the versions of a file that both sides have changed. Returns the new local content; `None` if the versions
/// cannot be merged, so that the conflict remains.
pub type MergeConflict<'a> = dyn FnMut(&ControllerPath, &ConflictVersions) -> Option<Vec<u8>> + 'a;

/// Arguments of a pull.
pub struct PullRequest<'a> {
    /// Address without a password, which is remembered.
    pub address: String,
    /// Settings of the connections, which are remembered.
    pub connection: ConnectionSettings,
    /// Identity of the controller.
    pub identity: ControllerIdentity,
    /// Folders on the controller.
    pub folders: Vec<ControllerPath>,
    /// Merge of conflicts; without it, they are an error.
    pub merge: Option<&'a mut MergeConflict<'a>>,
    /// Conflicts that are decided for one side.
    pub decisions: PullDecisions,
    /// Whether applications and folders that the controller no longer has are removed here; otherwise they are an error.
    pub accepts_removals: bool,
}

/// Files and folders whose conflicts are decided for one side.
#[derive(Debug, Clone, Default, PartialEq, Eq)]
pub struct PullDecisions {
    /// The local version is kept, and becomes a local change, which the next push uploads.
    pub local: Vec<ControllerPath>,
    /// The controller's version replaces the local one. This applies to files that were removed here, too.
    pub controller: Vec<ControllerPath>,
}

impl PullDecisions {
    /// Whether the file is decided for both sides.
    pub(super) fn are_contradictory(&self, file: &ControllerPath) -> bool {
        file.is_in_any(&self.local) && file.is_in_any(&self.controller)
    }
}
