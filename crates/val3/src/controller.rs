//! The controller of a project: connection, progress and messages of `pull`, `status`, `push` and `diff`.

mod checked;
mod netrc;
mod observer;
pub(crate) mod password;
pub(crate) mod question;
mod report;
pub(crate) mod soap_client;
mod target;

use std::time::{SystemTime, UNIX_EPOCH};

use camino::{Utf8Path, Utf8PathBuf};
use val3_controller::{
    AddressFault, ConnectionSettings, ControllerAddress, ControllerError, ControllerFiles, ControllerIdentity,
    ControllerProject, ProjectState, RecoveredPush, RecoveryOutcome, check_identity, recover,
};

use crate::args::ConnectionArgs;
use crate::output::to_stderr;
use crate::paths::{Paths, current_folder};
use crate::printable::one_line;
use crate::signals::Signals;
use crate::user_error::UserError;

pub(crate) use checked::{CheckOutcome, check_new_tree};
pub(crate) use observer::ProgressObserver;
pub(crate) use report::{change_word, counted_files, listed_files, planned_lines, shown_bytes, status_lines};
pub(crate) use target::{ControllerTarget, check_no_option};

/// A project with a connection to its controller.
pub(crate) struct ControllerSession {
    pub(crate) project: ControllerProject,
    pub(crate) files: Box<dyn ControllerFiles>,
    pub(crate) identity: ControllerIdentity,
    pub(crate) observer: ProgressObserver,
    /// Address without a password.
    pub(crate) address: String,
    /// Settings of the connections.
    pub(crate) connection: ConnectionSettings,
    /// Pushes that were recovered.
    pub(crate) recovered: Vec<RecoveredPush>,
}

impl ControllerSession {
    /// Connects to the controller of a project, checks its identity, and recovers a push that was killed.
    pub(crate) fn open(
        mut project: ControllerProject,
        mut target: ControllerTarget,
        accepts_new: bool,
    ) -> Result<Self, UserError> {
        // Until the password is entered, a signal ends the process.
        let mut files = target.connect()?;
        let ControllerTarget { address, settings: connection } = target;
        let mut observer = ProgressObserver::new(Signals::catch()?);
        let identity = check_identity(&project, &address, &mut *files, accepts_new)?;
        let recovered = recover(&mut project, &mut *files, &identity, now(), &mut observer)?;
        observer.end();
        let address = address.to_string();
        let session = Self { project, files, identity, observer, address, connection, recovered };
        session.recovered.iter().for_each(|one| note(&recovered_line(one)));
        Ok(session)
    }

    /// Serial numbers for people.
    pub(crate) fn identity_line(&self) -> String {
        let ControllerIdentity { serial, arm } = &self.identity;
        let serial = if serial.is_empty() { "no serial number".to_owned() } else { format!("controller {serial}") };
        let arm = if arm.is_empty() { String::new() } else { format!(", arm {arm}") };
        format!("{}: {serial}{arm}", self.address)
    }
}

/// Parses an address. The path of a folder becomes absolute.
pub(crate) fn parse_address(text: &str) -> Result<ControllerAddress, UserError> {
    let address = ControllerAddress::parse(text).map_err(|fault| {
        let message = match fault {
            // The text may contain the password.
            AddressFault::Password => format!("this is no address of a controller: {fault}"),
            _ => format!("`{text}` is no address of a controller: {fault}"),
        };
        UserError::new(message)
            .with_help("write `ftp://PROFILE@HOST`, `ftps://PROFILE@HOST` for TLS, or the folder of an emulator")
    })?;
    Ok(match address {
        ControllerAddress::Folder(folder) => {
            ControllerAddress::Folder(Paths::new(&[], &current_folder()?).absolute(&folder))
        }
        address => address,
    })
}

/// Opens the project around a folder, which has a controller.
pub(crate) fn open_project(folder: &Utf8Path) -> Result<(ControllerProject, ControllerTarget), UserError> {
    let folder = Paths::new(&[], &current_folder()?).absolute(folder);
    let root = ControllerProject::around(&folder).ok_or_else(|| no_controller(&folder))?;
    let project = ControllerProject::open(&root)?;
    let state = project.state.as_ref().ok_or_else(|| no_controller(&folder))?;
    let target = ControllerTarget::new(parse_address(&state.address)?, &ConnectionArgs::default(), Some(state))?;
    Ok((project, target))
}

/// Error for a folder without a controller.
fn no_controller(folder: &Utf8Path) -> UserError {
    UserError::new(format!("`{folder}` belongs to no controller"))
        .with_help("run `val3 pull ADDRESS DIR` once, which remembers the controller")
}

/// State of the project around the current folder, for a command that also works without one.
pub(crate) fn surrounding_state() -> Result<Option<ProjectState>, UserError> {
    Ok(match ControllerProject::around(&current_folder()?) {
        None => None,
        Some(folder) => ControllerProject::open(&folder)?.state,
    })
}

/// Seconds since 1970.
pub(crate) fn now() -> u64 {
    SystemTime::now().duration_since(UNIX_EPOCH).map_or(0, |elapsed| elapsed.as_secs())
}

/// Writes a line to the standard error output.
pub(crate) fn note(line: &str) {
    to_stderr(|out| writeln!(out, "{}", one_line(line)));
}

/// Writes an error that is a result of the command to the standard error output.
pub(crate) fn report_error(error: &UserError) {
    to_stderr(|out| writeln!(out, "{error}"));
}

/// Path as the user would open it.
pub(crate) fn shown(path: &Utf8Path) -> Result<String, UserError> {
    Ok(Paths::new(&[], &current_folder()?).shown(path))
}

fn recovered_line(RecoveredPush { backup, outcome }: &RecoveredPush) -> String {
    match outcome {
        RecoveryOutcome::Cancelled => {
            "note: the last push was interrupted before it changed an application; its traces were removed".to_owned()
        }
        RecoveryOutcome::Completed => {
            "note: the last push was interrupted after its last file; the controller has the new files".to_owned()
        }
        RecoveryOutcome::Restored { count, kept } if kept.is_empty() => {
            format!(
                "note: the last push was interrupted; the old version of {count} files was restored from `{backup}`"
            )
        }
        RecoveryOutcome::Restored { count, kept } => {
            let kept = kept.iter().map(|path| format!("`{path}`")).collect::<Vec<_>>().join(", ");
            format!(
                "warning: the last push was interrupted; the old version of {} was restored from `{backup}`, but these \
                 files were changed meanwhile and were kept: {kept}",
                counted_files(*count)
            )
        }
    }
}

impl From<ControllerError> for UserError {
    fn from(error: ControllerError) -> Self {
        let worded = Self::new(error.to_string());
        match (&error, error.help()) {
            (ControllerError::NoApplication { folder, present }, _) => {
                worded.with_help(report::application_help(folder.name(), present))
            }
            (_, "") => worded,
            (_, help) => worded.with_help(help),
        }
    }
}

/// Folder of a new project: the argument, else the project around the current folder, else the current folder.
pub(crate) fn project_folder(folder: Option<&Utf8Path>) -> Result<Utf8PathBuf, UserError> {
    let current = current_folder()?;
    Ok(match folder {
        Some(folder) => Paths::new(&[], &current).absolute(folder),
        None => ControllerProject::around(&current).unwrap_or(current),
    })
}
