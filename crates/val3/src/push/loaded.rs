//! Loaded applications: a controller may reject files of an application that it has loaded, or run old and new files.

use val3_backup::log::{ApplicationState, UnknownCause};
use val3_controller::{ControllerAddress, ControllerFiles, PushPlan, TransferObserver};
use val3_soap::v1::GetApplications;

use super::logs::application_state;
use crate::controller::note;
use crate::controller::question::{can_ask, is_confirmed};
use crate::controller::soap_client::{SoapClient, SoapTarget};
use crate::printable::one_line;
use crate::user_error::UserError;

/// Option that states that no application is loaded.
const OPTION: &str = "stop and unload it on the controller, then add --unloaded";

/// Source of the information which applications are loaded.
#[derive(Debug, Clone, Copy)]
pub(super) enum LoadEvidence<'t> {
    /// The user states that no application is loaded, or the push changes no application.
    Statement,
    /// The SOAP interface of the controller.
    Interface(&'t SoapTarget),
    /// The logs of the controller, which contain starts and stops.
    Log,
}

/// Checks that the SOAP interface and the FTP server have the same host. A folder has none.
///
/// # Errors
/// The hosts differ: the interface would name the applications of another controller.
pub(super) fn check_host(soap: &SoapTarget, address: &ControllerAddress) -> Result<(), UserError> {
    match address {
        ControllerAddress::Ftp(ftp) if !soap.host().eq_ignore_ascii_case(&ftp.server.host) => {
            let message = format!("`--soap` names the host {}, but the project is on {}", soap.host(), ftp.server.host);
            Err(UserError::new(message).with_help("write the host as in the address of the controller"))
        }
        _ => Ok(()),
    }
}

/// Reason why the push is refused; `None` if no application is loaded.
///
/// # Errors
/// The interface, the log or the answer cannot be read.
pub(super) fn refusal(
    files: &mut dyn ControllerFiles,
    plan: &PushPlan,
    observer: &mut dyn TransferObserver,
    evidence: LoadEvidence<'_>,
) -> Result<Option<UserError>, UserError> {
    match evidence {
        LoadEvidence::Statement => Ok(None),
        LoadEvidence::Interface(target) => refusal_of_interface(target),
        LoadEvidence::Log => refusal_of_log(files, plan, observer),
    }
}

fn refusal_of_interface(target: &SoapTarget) -> Result<Option<UserError>, UserError> {
    let loaded = loaded_applications(target)?;
    if loaded.is_empty() {
        return Ok(None);
    }
    let message = format!("loaded on the controller: `{}`", loaded.join("`, `"));
    Ok(Some(UserError::new(message).with_help("stop and unload them on the controller, then push again")))
}

/// Names of the projects in memory, for example `Disk://demo/demo.pjx`.
fn loaded_applications(target: &SoapTarget) -> Result<Vec<String>, UserError> {
    let mut client = SoapClient::login(target)?;
    let answer = client.call(&GetApplications {});
    let closed = client.logout();
    let listed = answer?.applications.into_iter().filter(|application| application.loaded);
    closed?;
    Ok(listed.map(|application| one_line(&application.name.unwrap_or_default()).into_owned()).collect())
}

fn refusal_of_log(
    files: &mut dyn ControllerFiles,
    plan: &PushPlan,
    observer: &mut dyn TransferObserver,
) -> Result<Option<UserError>, UserError> {
    match application_state(files, observer)? {
        ApplicationState::NoneRuns => Ok(None),
        ApplicationState::Running(running) => {
            let names = running.into_iter().collect::<Vec<_>>().join("`, `");
            let message = format!("`{names}` runs on the controller, according to its log");
            Ok(Some(UserError::new(message).with_help(OPTION)))
        }
        ApplicationState::Unknown(cause) if can_ask() => ask(&plan.applications().join("`, `"), &cause),
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
