//! Controllers in a backup: a backup can contain one, several, or only the content of `usr`.

use std::collections::BTreeSet;

use crate::BackupFile;

/// Folders of which each marks its parent as the `usr` of a controller.
const MARKS: [&str; 2] = ["usrapp", "configs"];

/// Folders that belong to a controller.
#[derive(Debug, Clone, PartialEq, Eq, PartialOrd, Ord)]
pub struct ControllerRoot {
    /// Path of the folder with `usr`, `sys` and `log`; empty for the root of the backup.
    pub path: String,
    /// Path of the folder with `usrapp` and `configs`; empty for the root of the backup.
    pub usr: String,
}

/// Returns the controllers in a backup, sorted by path. A backup without any of the usual folders is one controller, of
/// which only the applications are known.
#[must_use]
pub fn controller_roots(files: &[BackupFile]) -> Vec<ControllerRoot> {
    let found: BTreeSet<ControllerRoot> = files.iter().filter_map(|file| root_of(&file.path)).collect();
    if found.is_empty() {
        return vec![ControllerRoot { path: String::new(), usr: String::new() }];
    }
    found.into_iter().collect()
}

/// Returns the controller of a file, by the uppermost folder that marks one.
fn root_of(path: &str) -> Option<ControllerRoot> {
    let mut above: Vec<&str> = Vec::new();
    for part in path.split('/') {
        let is_mark = MARKS.iter().any(|mark| mark.eq_ignore_ascii_case(part));
        let is_of_system = above.last().is_some_and(|folder| folder.eq_ignore_ascii_case("sys"));
        if is_mark && !is_of_system && above.len() < path.matches('/').count() {
            let usr = above.join("/");
            let controller = match above.split_last() {
                Some((last, controller)) if last.eq_ignore_ascii_case("usr") => controller.join("/"),
                _ => usr.clone(),
            };
            return Some(ControllerRoot { path: controller, usr });
        }
        above.push(part);
    }
    None
}

#[cfg(test)]
mod tests {
    use super::*;

    fn roots(paths: &[&str]) -> Vec<(String, String)> {
        let files = paths.iter().map(|&path| BackupFile { path: path.to_owned(), size: 0, modified: None });
        let files: Vec<BackupFile> = files.collect();
        controller_roots(&files).into_iter().map(|root| (root.path, root.usr)).collect()
    }

    fn pairs(pairs: &[(&str, &str)]) -> Vec<(String, String)> {
        pairs.iter().map(|(path, usr)| ((*path).to_owned(), (*usr).to_owned())).collect()
    }

    #[test]
    fn controllers_are_found_at_any_depth() {
        assert_eq!(
            roots(&["usr/usrapp/a/a.pjx", "usr/configs/arm.cfx", "sys/configs/options.cfx"]),
            pairs(&[("", "usr")])
        );
        assert_eq!(roots(&["usrapp/a/a.pjx"]), pairs(&[("", "")]));
        let two = roots(&["x/C1/usr/configs/arm.cfx", "x/C2/USR/Configs/arm.cfx"]);
        assert_eq!(two, pairs(&[("x/C1", "x/C1/usr"), ("x/C2", "x/C2/USR")]));
    }

    #[test]
    fn other_folders_are_one_controller() {
        assert_eq!(roots(&["a/a.pjx", "b/b.pjx", "configs"]), pairs(&[("", "")]));
        assert_eq!(roots(&[]), pairs(&[("", "")]));
    }
}
