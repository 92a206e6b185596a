//! Controller description, from the files in a backup.
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
pub use controller::{Board, ControllerInfo};
pub use options::{ControllerOption, OptionState};
pub use roots::{ControllerRoot, controller_roots};
pub use users::User;

/// Describes the controller with this root.
#[must_use]
pub fn controller_info(files: &dyn BackupFiles, root: &ControllerRoot) -> ControllerInfo {
    controller::read(files, root)
}
