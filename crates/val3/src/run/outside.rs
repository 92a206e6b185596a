//! External effects on a running application: the operator and the script.

use std::time::SystemTime;

use camino::Utf8Path;
use val3_files::FileClass;
use val3_machine::controller::Controller;
use val3_machine::controller_state::Calendar;
use val3_machine::script::ScriptAction;
use val3_suite::{Scenario, ScenarioError};

use super::replay::RunRecording;
use crate::args::RunArgs;
use crate::user_error::UserError;

/// Sets up the operator, the script and the calendar from the arguments, or the actions of the recording that they name.
/// `is_resized` returns whether a data item changes its size. Returns a note for the user.
///
/// # Errors
/// The script names an unknown variable or signal, or the recording cannot be repeated.
pub(super) fn arrange(
    controller: &mut Controller,
    args: &RunArgs,
    script: Option<&Scenario>,
    is_resized: &dyn Fn(&str) -> bool,
) -> Result<Option<String>, UserError> {
    let mut note = None;
    if let Some(path) = args.replay.as_ref().filter(|_| !has_actions(args)) {
        let (actions, silent) = RunRecording::open(path)?.actions()?;
        note = actions.note();
        actions.arrange(silent, controller)?;
    }
    if let (Some(path), Some(scenario)) = (&args.script, script) {
        let faults = controller.script_faults(scenario.script(), is_resized);
        check_script(path, &faults.iter().map(ToString::to_string).collect::<Vec<_>>())?;
        controller.follow(scenario.script().clone());
    }
    if !args.set.is_empty() {
        let set = ScriptAction::setting(args.set.iter().cloned().collect());
        controller.act(&set).map_err(|problems| {
            UserError::new(format!("--set: {}", problems.join("; ")))
                .with_help("name a global variable of the type bool, num or string, or such a field: mFast.leave=20")
        })?;
    }
    let keys: Vec<u16> = args.keys.iter().flat_map(|keys| keys.0.iter().copied()).collect();
    if !keys.is_empty() {
        controller.act(&ScriptAction::typing(keys)).map_err(|problems| UserError::new(problems.join("; ")))?;
    }
    if args.follows_wall() && args.controller.date.is_none() {
        controller.devices.state.calendar = today();
    }
    Ok(note)
}

/// Whether the arguments name actions, which replace those of a recording.
fn has_actions(args: &RunArgs) -> bool {
    args.script.is_some() || !args.keys.is_empty() || !args.set.is_empty()
}

/// Checks that a script has no faults.
///
/// # Errors
/// The script has faults, which the message lists.
pub(crate) fn check_script(path: &Utf8Path, faults: &[String]) -> Result<(), UserError> {
    let listed: Vec<String> = faults.iter().map(|fault| format!("  {fault}")).collect();
    let unusable = || UserError::new(format!("the script `{path}` cannot be used")).with_details(listed.join("\n"));
    if faults.is_empty() { Ok(()) } else { Err(unusable()) }
}

/// Reads a script file. Scenario files are valid, too: a run ignores their expectations.
///
/// # Errors
/// The file cannot be read, or has an invalid key or value.
pub(crate) fn read_script(path: &Utf8Path) -> Result<Scenario, UserError> {
    let text = val3_files::read_text(path, FileClass::Settings).map_err(|error| {
        UserError::new(format!("cannot read the script `{path}`: {error}"))
            .with_help("name a TOML file with an [[at]] for each time at which something happens, and a [[when]] for each reaction")
    })?;
    Scenario::parse(path.as_str(), &text).map_err(|error| unusable_script(path, &error))
}

/// Error of a script with an invalid key or value.
pub(crate) fn unusable_script(path: &Utf8Path, error: &ScenarioError) -> UserError {
    UserError::new(format!("the script `{path}` cannot be used")).with_details(error.to_string())
}

fn today() -> Calendar {
    let since = SystemTime::now().duration_since(SystemTime::UNIX_EPOCH);
    since.map_or_else(|_| Calendar::default(), |since| Calendar::starting_at_unix(since.as_secs()))
}
