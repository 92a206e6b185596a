//! Files that are not compared, and files that are never written.

use crate::path::{ControllerPath, has_suffix};

/// Folder of the controller's logs.
pub const LOG_FOLDER: &str = "log";

/// Name of the lock below the applications.
pub(crate) const LOCK_NAME: &str = "val3.lock";

/// Folder of the controller's settings.
const SETTINGS: &str = "usr/configs";

/// Whether a file is neither transferred nor compared: files of tools, temporary files and the lock.
pub(crate) fn is_ignored(path: &ControllerPath) -> bool {
    let name = path.name();
    name == ".pyftpsync-meta.json"
        || name == ".outlining.json"
        || name == LOCK_NAME && path.parent() == Some(ControllerPath::applications())
        || [".bak", ".val3tmp", ".val3-tmp", ".val3-old"].iter().any(|suffix| has_suffix(name, suffix))
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
        for path in ["usr/usrapp/val3.lock", "usr/usrapp/a/.pyftpsync-meta.json", "usr/a.BAK", "usr/a.pgx.val3tmp"] {
            assert!(is_ignored(&ControllerPath::parse(path).unwrap()), "{path}");
        }
        assert!(!is_ignored(&ControllerPath::parse("usr/usrapp/demo/val3.lock").unwrap()));
    }
}
