//! Description of a controller from the files of its backup.
//!
//! Passwords and licence codes are never read into the description: [`cfx`] omits passwords, and an option only has a
//! state.

mod applications;
mod cfx;
mod controller;
mod options;
mod roots;
mod users;

use crate::BackupFiles;

pub use applications::ApplicationInfo;
pub use cfx::{TextFiles, joined};
pub use controller::ControllerInfo;
pub use options::{ControllerOption, OptionState};
pub use roots::{ControllerRoot, controller_roots};
pub use users::User;

/// A file of the controller that exists but cannot be read.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct UnreadFile {
    /// Path in the backup.
    pub path: String,
    /// Reason.
    pub reason: String,
}

/// Describes the controller with this root.
#[must_use]
pub fn controller_info(files: &dyn BackupFiles, root: &ControllerRoot) -> ControllerInfo {
    controller::read(files, root)
}
