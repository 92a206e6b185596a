//! Reads the logs at a path: one file, or the logs of one controller in a folder or an archive.

use camino::{Utf8Path, Utf8PathBuf};
use val3_backup::log::{LogFolder, LoggedEntry, entries, foreign_content, log_folders, merged};
use val3_controller::LOG_FOLDER;
use val3_files::{FileClass, is_archive_name};

use crate::args::LogArgs;
use crate::backup_files::{OpenedBackup, RemoteFolders, open, open_address};
use crate::paths::{Paths, is_address};
use crate::user_error::UserError;

/// Names of logs, for messages.
pub(super) const NAMES: &str = "errors.log, system.log or user.log";

/// Folders of a controller at an address: logs, and programs for the source lines of messages.
const FOLDERS: RemoteFolders = RemoteFolders { downloaded: &[], listed: &[LOG_FOLDER, "usr/usrapp"] };

/// Folders of a controller whose programs are not searched.
const LOG_FOLDERS: RemoteFolders = RemoteFolders { downloaded: &[], listed: &[LOG_FOLDER] };

/// Entries of the logs.
pub(super) struct ReadLog {
    /// Entries in the order of their times.
    pub(super) logged: Vec<LoggedEntry>,
    /// Absolute path or address of the folder with the logs.
    pub(super) folder: Utf8PathBuf,
    /// The folder, archive or controller that was read; `None` if the path is a single file.
    pub(super) backup: Option<OpenedBackup>,
}

/// Reads the logs at an absolute path.
pub(super) fn read(path: &Utf8Path, paths: &Paths) -> Result<ReadLog, UserError> {
    if path.is_dir() || is_archive_name(path) {
        return read_backup(open(path)?, paths);
    }
    let bytes =
        val3_files::read(path, FileClass::Record).map_err(|reason| unreadable(path, &reason.to_string(), paths))?;
    let logged = file_entries(&bytes, path, paths)?;
    let folder = path.parent().unwrap_or(path).to_owned();
    Ok(ReadLog { logged, folder, backup: None })
}

/// Returns the entries of a file.
pub(super) fn file_entries(bytes: &[u8], path: &Utf8Path, paths: &Paths) -> Result<Vec<LoggedEntry>, UserError> {
    if let Some(reason) = foreign_content(bytes) {
        return Err(unreadable(path, &reason, paths));
    }
    let file = paths.to_open(path);
    Ok(entries(bytes).map(|entry| LoggedEntry { file: file.clone(), entry }).collect())
}

/// Reads the logs of the controller at an address. With other sources, its programs are not listed.
pub(super) fn read_address(args: &LogArgs, paths: &Paths) -> Result<ReadLog, UserError> {
    let folders = if args.sources.is_some() { &LOG_FOLDERS } else { &FOLDERS };
    read_backup(open_address(&args.path, &args.connection, folders)?, paths)
}

fn read_backup(backup: OpenedBackup, paths: &Paths) -> Result<ReadLog, UserError> {
    let path = &backup.root;
    let folders = log_folders(backup.files.files());
    let LogFolder { path: folder, logs } =
        uppermost(&folders, path, paths).map_err(|error| error.with_details(unsearched(&backup, paths).join("\n")))?;
    let mut read = Vec::new();
    for files in logs {
        let mut log = Vec::new();
        for file in files {
            let place = path.join(file);
            let bytes = backup.files.read(file).map_err(|reason| unreadable(&place, &reason, paths))?;
            log.extend(file_entries(&bytes, &place, paths)?);
        }
        read.push(log);
    }
    let folder = path.join(folder);
    Ok(ReadLog { logged: merged(read), folder, backup: Some(backup) })
}

/// Returns a sentence for each folder of a backup that was not searched for logs.
pub(super) fn unsearched(backup: &OpenedBackup, paths: &Paths) -> Vec<String> {
    let folders = backup.unread.iter().map(|(path, reason)| (paths.shown(path), reason));
    folders.map(|(path, reason)| format!("no logs are searched in `{path}`: {reason}")).collect()
}

/// Returns the only uppermost folder with logs. Logs of other controllers may lie in folders below it.
fn uppermost<'f>(folders: &'f [LogFolder], path: &Utf8Path, paths: &Paths) -> Result<&'f LogFolder, UserError> {
    let depth = |folder: &LogFolder| Utf8Path::new(&folder.path).components().count();
    let shown = paths.shown(path);
    let Some(first) = folders.first() else {
        let message = format!("there is no log in `{shown}`");
        return Err(UserError::new(message).with_help(match is_address(path) {
            true => "name the folder of the server that contains `usr` and `log`".to_owned(),
            false => format!("name a file or a folder with {NAMES}"),
        }));
    };
    let names: Vec<String> = folders
        .iter()
        .filter(|folder| depth(folder) == depth(first))
        .map(|folder| format!("`{}`", paths.shown(&path.join(&folder.path))))
        .collect();
    if names.len() == 1 {
        return Ok(first);
    }
    let message = format!("`{shown}` contains the logs of several controllers: {}", names.join(", "));
    Err(UserError::new(message).with_help("name one of the folders"))
}

/// Returns the error for a log that cannot be read.
pub(super) fn unreadable(path: &Utf8Path, reason: &str, paths: &Paths) -> UserError {
    UserError::new(format!("cannot read the log `{}`: {reason}", paths.shown(path)))
        .with_help(format!("name a file or a folder with {NAMES}"))
}
