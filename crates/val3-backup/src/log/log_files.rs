//! Log files in a backup.

use std::collections::BTreeMap;

use crate::BackupFile;

/// Logs that a controller writes, by name without extension. The files end in `.log`; their predecessors, after a file
/// has reached its maximum size, end in `.old`.
const LOGS: [&str; 3] = ["errors", "system", "user"];

/// Extensions of a log's files, oldest file first.
const EXTENSIONS: [&str; 2] = ["old", "log"];

/// Log folder of a controller.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct LogFolder {
    /// Path in the backup; empty for the root.
    pub path: String,
    /// Paths of each log's files, oldest file first.
    pub logs: Vec<Vec<String>>,
}

/// Folder of a backup. The order begins with the uppermost folders.
#[derive(PartialEq, Eq, PartialOrd, Ord)]
struct Folder<'a> {
    depth: usize,
    path: &'a str,
}

/// File of a log. The order is that of [`LOGS`], and the oldest file of a log comes first.
#[derive(PartialEq, Eq, PartialOrd, Ord)]
struct LogFile<'a> {
    /// Number in [`LOGS`].
    log: usize,
    /// Number in [`EXTENSIONS`].
    age: usize,
    path: &'a str,
}

/// Returns the folders with logs, the uppermost folders first.
#[must_use]
pub fn log_folders(files: &[BackupFile]) -> Vec<LogFolder> {
    let mut found: BTreeMap<Folder<'_>, Vec<LogFile<'_>>> = BTreeMap::new();
    for file in files {
        let (folder, name) = file.path.rsplit_once('/').unwrap_or(("", &file.path));
        let Some(log_file) = LogFile::new(&file.path, name) else { continue };
        let depth = if folder.is_empty() { 0 } else { 1 + folder.matches('/').count() };
        found.entry(Folder { depth, path: folder }).or_default().push(log_file);
    }
    found.into_iter().map(|(folder, files)| LogFolder { path: folder.path.to_owned(), logs: logs(files) }).collect()
}

/// Paths of the files by log.
fn logs(mut files: Vec<LogFile<'_>>) -> Vec<Vec<String>> {
    files.sort_unstable();
    let logs = files.chunk_by(|one, other| one.log == other.log);
    logs.map(|log| log.iter().map(|file| file.path.to_owned()).collect()).collect()
}

impl<'a> LogFile<'a> {
    /// Returns the file if it has the name of a log file.
    fn new(path: &'a str, name: &str) -> Option<Self> {
        let name = name.to_ascii_lowercase();
        let (stem, extension) = name.rsplit_once('.')?;
        let position = |names: &[&str], name| names.iter().position(|known| *known == name);
        Some(Self { log: position(&LOGS, stem)?, age: position(&EXTENSIONS, extension)?, path })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn logs_are_found_with_their_predecessors() {
        let paths = ["a/log/b/user.log", "a/log/arm.json", "a/log/system.log", "a/log/SYSTEM.OLD", "a/log/user.log"];
        let files = paths.map(|path| BackupFile { path: path.to_owned(), size: 0, modified: None });
        let folders = log_folders(&files);
        assert_eq!(folders.iter().map(|folder| folder.path.as_str()).collect::<Vec<_>>(), ["a/log", "a/log/b"]);
        assert_eq!(folders[0].logs, [vec!["a/log/SYSTEM.OLD", "a/log/system.log"], vec!["a/log/user.log"]]);
    }

    #[test]
    fn a_file_in_the_root_is_a_log() {
        let files = [BackupFile { path: "errors.log".to_owned(), size: 0, modified: None }];
        assert_eq!(log_folders(&files)[0].path, "");
    }
}
