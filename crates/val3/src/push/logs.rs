//! Applications that run on the controller, according to all its logs.

use val3_backup::BackupFile;
use val3_backup::log::{ApplicationHistory, ApplicationState, entries, foreign_content, log_folders};
use val3_controller::{ControllerError, ControllerFiles, ControllerPath, LOG_FOLDER, TransferObserver, files_below};

use crate::user_error::UserError;

/// Limit of a log file in bytes. A CS9 log with 147,000 entries has about 30 MB.
const LIMIT: u64 = 100 << 20;

/// Reads the logs with their older files.
///
/// # Errors
/// A log cannot be read, or is no log.
pub(super) fn application_state(
    files: &mut dyn ControllerFiles,
    observer: &mut dyn TransferObserver,
) -> Result<ApplicationState, UserError> {
    let folder = ControllerPath::parse(LOG_FOLDER).map_err(ControllerError::Name)?;
    let paths = files_below(files, &[folder], observer)?;
    let listed = paths.into_iter().map(|path| BackupFile { path: path.into(), size: 0, modified: None });
    let logs = log_folders(&listed.collect::<Vec<_>>()).into_iter().flat_map(|folder| folder.logs);
    let histories: Result<Vec<_>, UserError> = logs.map(|log| history(&log, files)).collect();
    Ok(ApplicationHistory::state(histories?))
}

/// Reads the files of one log, oldest file first.
fn history(paths: &[String], files: &mut dyn ControllerFiles) -> Result<ApplicationHistory, UserError> {
    let mut history = ApplicationHistory::default();
    for path in paths {
        let file = ControllerPath::parse(path).map_err(ControllerError::Name)?;
        let bytes = files.read(&file, LIMIT).map_err(ControllerError::from)?;
        if let Some(reason) = foreign_content(&bytes) {
            return Err(UserError::new(format!("cannot read the log `{path}` of the controller: {reason}"))
                .with_help("stop and unload the applications on the controller, then add --unloaded"));
        }
        entries(&bytes).for_each(|entry| history.advance(&entry));
    }
    Ok(history)
}
