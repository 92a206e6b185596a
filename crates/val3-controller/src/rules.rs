//! Files that are not compared, and files that are never written.

use crate::path::{ControllerPath, has_suffix};

/// Folder of the controller's logs.
pub const LOG_FOLDER: &str = "log";

/// Name of the lock below the applications.
pub(crate) const LOCK_NAME: &str = "val3.lock";

/// Folder of the controller's settings.
const SETTINGS: &str = "usr/configs";

/// Files and folders of version control, file managers, editors and other clients. A repository or an editor's folder on a
/// controller is of no use there. Names of files that a program could write are not in the list.
const TOOLS: [&str; 18] = [
    ".bzr",
    ".ds_store",
    ".git",
    ".gitattributes",
    ".github",
    ".gitignore",
    ".gitmodules",
    ".hg",
    ".hgignore",
    ".idea",
    ".outlining.json",
    ".pyftpsync-meta.json",
    ".svn",
    ".val3",
    ".vs",
    ".vscode",
    "desktop.ini",
    "thumbs.db",
];

/// Endings of backups and temporary files.
const ENDINGS: [&str; 6] = [".bak", ".swp", ".val3tmp", ".val3-tmp", ".val3-old", "~"];

/// Whether a file or folder is neither transferred nor compared, because it belongs to a tool, is temporary, or is the lock.
pub(crate) fn is_ignored(path: &ControllerPath) -> bool {
    let name = path.name().to_ascii_lowercase();
    TOOLS.contains(&name.as_str())
        // Resource forks, which macOS writes to other file systems.
        || name.starts_with("._")
        || name == LOCK_NAME && path.parent() == Some(ControllerPath::applications())
        || ENDINGS.iter().any(|ending| name.ends_with(ending))
}

/// Whether a push may write a file. Profiles, the arm, the controller's identity, safety and the fieldbus images decide
/// on the safety of the cell, and are never written.
#[must_use]
pub fn is_protected(path: &ControllerPath) -> bool {
    let name = path.name().to_ascii_lowercase();
    let settings = path.as_str().strip_prefix(SETTINGS).and_then(|rest| rest.strip_prefix('/'));
    let is_protected_setting = settings.is_some_and(|inner| {
        inner.to_ascii_lowercase().starts_with("profiles/")
            || name.starts_with("arm") && (has_suffix(&name, ".cfx") || has_suffix(&name, ".cf"))
            || name == "controller.cfx"
            || name.starts_with("safety")
            || name == "sfty.dat"
    });
    let is_user_folder = path.as_str().starts_with("usr/");
    is_protected_setting || has_suffix(&name, ".nxd") || !is_user_folder
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn safety_and_identity_are_protected() {
        for path in [
            "usr/configs/profiles/default.cfx",
            "usr/configs/arm.cfx",
            "usr/configs/ARM.2.CFX",
            "usr/configs/controller.cfx",
            "usr/configs/safetyStruct.json",
            "usr/configs/sfty.dat",
            "usr/configs/hilscher/J207J208.nxd",
            "sys/configs/options.cfx",
            "log/user.log",
        ] {
            assert!(is_protected(&ControllerPath::parse(path).unwrap()), "{path}");
        }
        for path in ["usr/usrapp/demo/arm.pgx", "usr/usrapp/demo/demo.pjx", "usr/configs/sio.cfx", "usr/app/a.so"] {
            assert!(!is_protected(&ControllerPath::parse(path).unwrap()), "{path}");
        }
    }

    #[test]
    fn files_of_tools_are_ignored() {
        for path in [
            "usr/usrapp/val3.lock",
            "usr/usrapp/a/.pyftpsync-meta.json",
            "usr/a.BAK",
            "usr/a.pgx.val3tmp",
            "usr/usrapp/.git",
            "usr/usrapp/a/.svn",
            "usr/usrapp/a/.DS_Store",
            "usr/usrapp/a/._start.pgx",
            "usr/usrapp/a/Thumbs.db",
            "usr/usrapp/a/start.pgx~",
        ] {
            assert!(is_ignored(&ControllerPath::parse(path).unwrap()), "{path}");
        }
        for path in
            ["usr/usrapp/demo/val3.lock", "usr/usrapp/git/git.pjx", "usr/usrapp/a/.settings", "usr/usrapp/a/git"]
        {
            assert!(!is_ignored(&ControllerPath::parse(path).unwrap()), "{path}");
        }
    }
}
