//! Loaded applications: a controller may reject files of an application that it has loaded, or run old and new files.

use val3_backup::log::{ApplicationState, UnknownCause};
use val3_controller::{ControllerFiles, PushPlan, TransferObserver};

use super::logs::application_state;
use crate::controller::note;
use crate::controller::question::{can_ask, is_confirmed};
use crate::printable::one_line;
use crate::user_error::UserError;

/// Option that states that no application is loaded.
const OPTION: &str = "stop and unload it on the controller, then add --unloaded";

/// Reason why the push is refused; `None` if none of its applications is loaded.
///
/// # Errors
/// The log or the answer cannot be read.
pub(super) fn refusal(
    files: &mut dyn ControllerFiles,
    plan: &PushPlan,
    observer: &mut dyn TransferObserver,
    is_unloaded: bool,
) -> Result<Option<UserError>, UserError> {
    let applications = plan.applications();
    if is_unloaded || applications.is_empty() {
        return Ok(None);
    }
    match application_state(files, observer)? {
        ApplicationState::NoneRuns => Ok(None),
        ApplicationState::Running(running) => {
            let names = running.into_iter().collect::<Vec<_>>().join("`, `");
            let message = format!("`{names}` runs on the controller, according to its log");
            Ok(Some(UserError::new(message).with_help(OPTION)))
        }
        ApplicationState::Unknown(cause) if can_ask() => ask(&applications.join("`, `"), &cause),
        ApplicationState::Unknown(cause) => Ok(Some(unknown(&cause))),
    }
}

fn unknown(cause: &UnknownCause) -> UserError {
    UserError::new("the log of the controller does not state whether an application is loaded")
        .with_details(one_line(&cause.to_string()).into_owned())
        .with_help(OPTION)
}

fn ask(names: &str, cause: &UnknownCause) -> Result<Option<UserError>, UserError> {
    note(&format!("note: whether an application runs is unknown: {cause}"));
    let is_unloaded = is_confirmed(&format!("Are the applications stopped and unloaded: `{names}`?"))?;
    Ok((!is_unloaded).then(|| UserError::new("nothing was pushed").with_help(OPTION)))
}
