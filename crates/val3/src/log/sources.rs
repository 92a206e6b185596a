//! Programs to which messages refer.

use camino::{Utf8Path, Utf8PathBuf};
use val3_backup::log::{LogEntry, ProgramSources, SourceLine};

use crate::backup_files::{OpenedBackup, open};
use crate::user_error::UserError;

/// Number of folders above a log in which its cell is searched: `Controller1/log/192.168.0.254/user.log`.
const LEVELS: usize = 4;

/// Programs of the applications at hand.
pub(super) struct Sources(Option<(OpenedBackup, ProgramSources)>);

impl Sources {
    /// Opens the folder or archive of `--sources`, otherwise the backup that contains the logs, otherwise the cell
    /// around the folder with the logs.
    pub(super) fn open(
        requested: Option<Utf8PathBuf>,
        logs: &Utf8Path,
        backup: Option<OpenedBackup>,
    ) -> Result<Self, UserError> {
        let opened = match requested {
            Some(path) => Some(open(&path)?),
            None => match backup.filter(has_programs) {
                Some(backup) => Some(backup),
                None => applications_around(logs).map(|folder| open(&folder)).transpose()?,
            },
        };
        Ok(Self(opened.map(|backup| {
            let programs = ProgramSources::new(backup.files.files());
            (backup, programs)
        })))
    }

    /// Returns the lines to which a message may refer, with their absolute paths.
    pub(super) fn lines(&self, entry: &LogEntry, application: Option<&str>) -> Vec<(Utf8PathBuf, SourceLine)> {
        let Some((backup, programs)) = &self.0 else { return Vec::new() };
        let lines = programs.lines(backup.files.as_ref(), &entry.subject(), application);
        lines.into_iter().map(|line| (backup.root.join(&line.path), line)).collect()
    }

    /// Returns notes about folders that were not searched.
    pub(super) fn unread(&self) -> Vec<String> {
        let unread = self.0.iter().flat_map(|(backup, _)| &backup.unread);
        unread.map(|(path, reason)| format!("no programs are searched in `{path}`: {reason}")).collect()
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
