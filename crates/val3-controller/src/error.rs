//! Errors of transfers, with what to do.

use std::fmt::{self, Display};

use camino::Utf8PathBuf;

use crate::access::AccessError;
use crate::identity::ControllerIdentity;
use crate::path::{ControllerPath, NameFault};

/// Reason why a transfer has stopped.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum ControllerError {
    /// An operation on the controller has failed.
    Access(AccessError),
    /// A local file or folder cannot be read or written.
    Local {
        /// The file or folder.
        path: Utf8PathBuf,
        /// The reason.
        reason: String,
    },
    /// The project state in `.val3/controller.toml` cannot be read.
    DamagedState {
        /// The file.
        path: Utf8PathBuf,
        /// The reason.
        reason: String,
    },
    /// The controller has no such file.
    Missing(ControllerPath),
    /// The address has no folder of applications.
    NoApplications {
        /// Host and port, or the folder.
        place: String,
    },
    /// A requested application has no files, neither on the controller nor at the last pull.
    NoApplication {
        /// The requested folder.
        folder: ControllerPath,
        /// Names of the controller's applications.
        present: Vec<String>,
    },
    /// A pull would remove whole local applications or settings folders; each with the file count.
    RemovesFolders(Vec<(ControllerPath, usize)>),
    /// A local file is where a pull needs a folder, or in a folder where it needs a file.
    Obstacle {
        /// The file of the controller.
        path: ControllerPath,
        /// The local file.
        obstacle: ControllerPath,
    },
    /// A conflict was decided where no file has one.
    NoConflict(ControllerPath),
    /// A conflict was decided for both sides.
    DecidedTwice(ControllerPath),
    /// A path is not allowed.
    Name(NameFault),
    /// A file has an unexpected form.
    Malformed {
        /// The file.
        file: String,
        /// The reason.
        reason: String,
    },
    /// Names in one folder that differ only in letter case.
    SameName(ControllerPath, ControllerPath),
    /// The files exceed the limit for their sum, in bytes.
    TooMuch(u64),
    /// Folders are nested more deeply than the limit.
    TooDeep(ControllerPath),
    /// More files than the limit.
    TooMany(usize),
    /// Files that both sides have changed since the last pull.
    Conflicts(Vec<ControllerPath>),
    /// Files that changed on the controller since the last pull.
    Outdated(Vec<ControllerPath>),
    /// Files that are never written.
    Protected(Vec<ControllerPath>),
    /// A push would remove this number of files, and leave no application.
    NoApplicationLeft(usize),
    /// A push would remove settings.
    RemovesSettings(Vec<ControllerPath>),
    /// The address belongs to another controller than the last pull.
    OtherController {
        /// Identity at the last pull.
        expected: ControllerIdentity,
        /// Identity now.
        found: ControllerIdentity,
    },
    /// The controller has no serial number by which it could be identified.
    NoSerial,
    /// The controller has no serial number, and its address differs from the last pull's address.
    OtherAddress {
        /// Address of the last pull.
        expected: String,
    },
    /// Another push is running.
    Locked {
        /// First line of the lock.
        owner: String,
        /// Seconds by which the time in the lock is ahead of the clock here; 0 if a difference of clocks explains it.
        ahead: u64,
    },
    /// Another process executes a pull or push of the project, or recovers a push.
    Running,
    /// A file was changed during the push.
    ChangedMeanwhile(ControllerPath),
    /// A file on the controller differs from the written content.
    NotAsWritten(ControllerPath),
    /// The user has interrupted the transfer.
    Interrupted,
    /// A local file has changed since it was checked.
    LocalChanged(ControllerPath),
    /// A push to another controller was not finished.
    UnfinishedElsewhere {
        /// Serial number of the other controller.
        serial: String,
        /// Folder of the backup.
        backup: String,
    },
}

impl From<AccessError> for ControllerError {
    fn from(error: AccessError) -> Self {
        Self::Access(error)
    }
}

impl ControllerError {
    /// Remedy; empty if the message contains it.
    #[must_use]
    pub fn help(&self) -> &'static str {
        match self {
            Self::Access(error) => error.help(),
            Self::Missing(_) => "name a file as `val3 status` does: usr/usrapp/demo/start.pgx",
            Self::DamagedState { .. } => {
                "restore the file, for example from git; or remove it and run `val3 pull ADDRESS`, which stops at files that differ"
            }
            Self::NoApplications { .. } => "name the folder that contains `usr`, or the root of the server",
            Self::RemovesFolders(_) => {
                "if they were removed on the controller on purpose, add --accept-removals; else check the address and the \
                 rights of the profile"
            }
            Self::Obstacle { .. } => "move it to another place, or remove it, then pull again",
            Self::NoConflict(_) => "`val3 status` lists the files that have changed on both sides",
            Self::DecidedTwice(_) => "name it, or a folder above it, for one side only",
            Self::OtherAddress { .. } => {
                "if this project belongs to the controller at the new address, add --new-controller; else pull into a new folder"
            }
            Self::LocalChanged(_) => "repeat the command when no other program writes the file",
            Self::SameName(..) => "rename one of them: many disks cannot store both",
            Self::TooMuch(_) | Self::TooMany(_) | Self::TooDeep(_) => "name the applications with --app",
            Self::Conflicts(_) => "merge the changes of both sides with `val3 pull --merge`",
            Self::Outdated(_) => "run `val3 pull` first, and check the result",
            Self::Protected(_) => "change safety, profiles, the arm and the controller's identity on the controller",
            Self::NoApplicationLeft(_) => {
                "restore the folder, for example with git, or pull the controller to another folder: `val3 pull ADDRESS DIR`; \
                 remove applications that are not used on the controller"
            }
            Self::RemovesSettings(_) => "restore the files here, or remove them on the controller",
            Self::OtherController { .. } => {
                "if the controller was replaced on purpose, add --new-controller; else pull into a new folder"
            }
            Self::NoSerial => "if it is an emulator or its number was erased, add --new-controller",
            Self::Locked { ahead: 1.., .. } => {
                "set the clocks; if no push is running, remove `usr/usrapp/val3.lock` on the controller, for example with an FTP client"
            }
            Self::Locked { .. } => "wait for its end; 10 minutes after its start, the lock is ignored",
            Self::Running => "wait for its end, then repeat the command",
            Self::ChangedMeanwhile(_) => "run `val3 pull`, then push again",
            Self::UnfinishedElsewhere { .. } => "connect to that controller, and run `val3 status`",
            _ => "",
        }
    }
}

impl Display for ControllerError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Access(error) => write!(f, "{error}"),
            Self::Local { path, reason } | Self::DamagedState { path, reason } => write!(f, "`{path}`: {reason}"),
            Self::Missing(path) => write!(f, "the controller has no file `{path}`"),
            Self::NoApplications { place } => write!(f, "there is no folder `usr/usrapp` at {place}"),
            Self::NoApplication { folder, .. } => write!(f, "the controller has no files in `{folder}`"),
            Self::RemovesFolders(folders) => {
                let folders = folders.iter().map(|(folder, files)| format!("`{folder}` ({files} here)"));
                let folders = folders.collect::<Vec<_>>().join(", ");
                write!(
                    f,
                    "the controller no longer has any files in {folders}, so the pull would remove all of them here"
                )
            }
            Self::Obstacle { path, obstacle } => {
                write!(f, "`{path}` cannot be written here, because `{obstacle}` exists")
            }
            Self::DecidedTwice(path) => {
                write!(f, "`{path}` is decided both for the local version and for the controller's")
            }
            Self::NoConflict(path) => write!(f, "no file has changed on both sides at `{path}`"),
            Self::Name(fault) => write!(f, "{fault}"),
            Self::Malformed { file, reason } => write!(f, "cannot read `{file}`: {reason}"),
            Self::SameName(one, other) => write!(f, "`{one}` and `{}` differ only in letter case", other.name()),
            Self::TooMuch(limit) => write!(f, "the files have more than {limit} bytes"),
            Self::TooDeep(folder) => write!(f, "the folder `{folder}` is nested too deeply"),
            Self::TooMany(limit) => write!(f, "there are more than {limit} files"),
            Self::Conflicts(paths) => {
                write!(f, "{} changed here and on the controller since the last pull: {}", count(paths), names(paths))
            }
            Self::Outdated(paths) => {
                write!(f, "{} changed on the controller since the last pull: {}", count(paths), names(paths))
            }
            Self::Protected(paths) => write!(f, "{} never written: {}", is_or_are(paths), names(paths)),
            Self::NoApplicationLeft(count) => write!(
                f,
                "no application is left in the local folder `{}`: the push would remove {count} files from the controller",
                ControllerPath::applications()
            ),
            Self::RemovesSettings(paths) => write!(f, "the push would remove settings: {}", names(paths)),
            Self::OtherController { expected, found } => write!(
                f,
                "this is another controller: its serial number is {}, and at the last pull it was {}",
                shown(&found.serial),
                shown(&expected.serial)
            ),
            Self::NoSerial => f.write_str("the controller has no serial number by which it could be identified"),
            Self::Locked { owner, ahead: 0 } => write!(f, "another push is running: {owner}"),
            Self::Locked { owner, ahead } => write!(
                f,
                "another push may be running: {owner}, whose clock is {} minutes ahead of the clock here",
                ahead / 60
            ),
            Self::OtherAddress { expected } => write!(
                f,
                "the controller has no serial number by which it could be identified, and at the last pull the address was \
                 `{expected}`"
            ),
            Self::ChangedMeanwhile(path) => write!(f, "`{path}` was changed on the controller during the push"),
            Self::NotAsWritten(path) => write!(f, "`{path}` on the controller is not what was written"),
            Self::Running => f.write_str("another process executes a pull or push of this project"),
            Self::Interrupted => f.write_str("interrupted"),
            Self::LocalChanged(path) => write!(f, "`{path}` was changed here meanwhile"),
            Self::UnfinishedElsewhere { serial, backup } => write!(
                f,
                "a push to the controller with the serial number {} was not finished (backup: `{backup}`)",
                shown(serial)
            ),
        }
    }
}

impl std::error::Error for ControllerError {}

fn shown(serial: &str) -> &str {
    if serial.is_empty() { "empty" } else { serial }
}

fn count(paths: &[ControllerPath]) -> String {
    if paths.len() == 1 { "1 file".to_owned() } else { format!("{} files", paths.len()) }
}

fn is_or_are(paths: &[ControllerPath]) -> &'static str {
    if paths.len() == 1 { "this file is" } else { "these files are" }
}

fn names(paths: &[ControllerPath]) -> String {
    const SHOWN: usize = 20;
    let mut text = paths.iter().take(SHOWN).map(|path| format!("`{path}`")).collect::<Vec<_>>().join(", ");
    if paths.len() > SHOWN {
        text.push_str(&format!(" and {} more", paths.len() - SHOWN));
    }
    text
}
