//! Programs to which messages refer.

use std::cell::RefCell;
use std::collections::BTreeMap;

use camino::{Utf8Path, Utf8PathBuf};
use val3_backup::log::{FoundLines, LogEntry, ProgramSources, SourceLine};

use crate::backup_files::{OpenedBackup, open};
use crate::user_error::UserError;

/// Number of folders above a log in which its cell is searched: `Controller1/log/192.168.0.254/user.log`.
const LEVELS: usize = 4;

/// Programs of the applications at hand.
pub(super) struct Sources {
    opened: Option<SearchedBackup>,
    /// Programs that could not be read, with the reason.
    unread: RefCell<BTreeMap<Utf8PathBuf, String>>,
}

/// Backup or cell with the index of its programs.
struct SearchedBackup {
    backup: OpenedBackup,
    programs: ProgramSources,
}

impl SearchedBackup {
    fn new(backup: OpenedBackup) -> Self {
        Self { programs: ProgramSources::new(backup.files.files()), backup }
    }
}

impl Sources {
    /// Opens the folder or archive of `--sources`, otherwise the backup or controller that contains the logs, otherwise
    /// the cell around the folder with the logs.
    pub(super) fn open(
        requested: Option<Utf8PathBuf>,
        logs: &Utf8Path,
        backup: Option<OpenedBackup>,
    ) -> Result<Self, UserError> {
        let opened = match requested {
            Some(path) => Some(open(&path)?),
            None => match backup.filter(|backup| backup.is_remote() || has_programs(backup)) {
                Some(backup) => Some(backup),
                None => applications_around(logs).map(|folder| open(&folder)).transpose()?,
            },
        };
        Ok(Self { opened: opened.map(SearchedBackup::new), unread: RefCell::default() })
    }

    /// Returns the lines to which a message may refer, with their absolute paths.
    pub(super) fn lines(&self, entry: &LogEntry, application: Option<&str>) -> Vec<(Utf8PathBuf, SourceLine)> {
        let Some(SearchedBackup { backup, programs }) = &self.opened else { return Vec::new() };
        let FoundLines { lines, unread } = programs.lines(backup.files.as_ref(), &entry.subject(), application);
        let unread = unread.into_iter().map(|file| (backup.root.join(file.path), file.reason));
        self.unread.borrow_mut().extend(unread);
        lines.into_iter().map(|line| (backup.root.join(&line.path), line)).collect()
    }

    /// Returns notes about folders that were not searched, and about programs that could not be read.
    pub(super) fn unread(&self) -> Vec<String> {
        let folders = self.opened.iter().flat_map(|opened| &opened.backup.unread);
        let folders = folders.map(|(path, reason)| format!("no programs are searched in `{path}`: {reason}"));
        let programs = self.unread.borrow();
        let programs = programs.iter().map(|(path, reason)| format!("cannot read `{path}`: {reason}"));
        folders.chain(programs).collect()
    }
}

fn has_programs(backup: &OpenedBackup) -> bool {
    backup.files.files().iter().any(|file| file.path.to_ascii_lowercase().ends_with(".pgx"))
}

/// Returns the folder of the applications in the cell around a folder.
fn applications_around(folder: &Utf8Path) -> Option<Utf8PathBuf> {
    let candidates = folder.ancestors().take(LEVELS);
    candidates.flat_map(|above| [above.join("usr/usrapp"), above.join("usrapp")]).find(|folder| folder.is_dir())
}
