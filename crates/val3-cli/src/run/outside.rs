//! Effects on an application from outside while it runs: the operator and the script.

use std::fs;
use std::time::SystemTime;

use camino::Utf8Path;
use val3_machine::controller::Controller;
use val3_machine::controller_state::Calendar;
use val3_machine::script::{Script, ScriptFault};
use val3_suite::Scenario;

use crate::args::RunArgs;
use crate::user_error::UserError;

/// Sets up the operator, the script and the wall calendar as the arguments say.
///
/// # Errors
/// The script cannot be read, contains an unknown action, or names a variable or signal that does not exist.
/// `is_resized` returns whether a data item changes its size.
pub(super) fn arrange(
    controller: &mut Controller,
    args: &RunArgs,
    is_resized: &dyn Fn(&str) -> bool,
) -> Result<(), UserError> {
    if let Some(path) = &args.script {
        follow_script(controller, path, read_script(path)?.script, is_resized)?;
    }
    controller.devices.state.pendant.type_on_request(args.keys.iter().flat_map(|keys| keys.0.iter().copied()));
    if args.follows_wall() && args.controller.date.is_none() {
        controller.devices.state.calendar = today();
    }
    Ok(())
}

/// Lets the controller follow the script of the file `path`.
///
/// # Errors
/// The script names a variable or signal that does not exist. `is_resized` returns whether a data item changes its size.
pub(crate) fn follow_script(
    controller: &mut Controller,
    path: &Utf8Path,
    script: Script,
    is_resized: &dyn Fn(&str) -> bool,
) -> Result<(), UserError> {
    let faults: Vec<String> = controller.script_faults(&script, is_resized).iter().map(worded).collect();
    if !faults.is_empty() {
        return Err(UserError::new(format!("the script `{path}` cannot be used\n{}", faults.join("\n"))));
    }
    controller.follow(script);
    Ok(())
}

/// Reads the file of a script. That of a scenario is one too: a run does what it says around the controller.
///
/// # Errors
/// The file cannot be read, or has a key or value that is not possible.
pub(crate) fn read_script(path: &Utf8Path) -> Result<Scenario, UserError> {
    let text = fs::read_to_string(path).map_err(|error| {
        UserError::new(format!("cannot read the script `{path}`: {error}"))
            .with_help("name a TOML file with an [[at]] table for each time at which something happens")
    })?;
    Scenario::parse(path.as_str(), &text)
        .map_err(|error| UserError::new(format!("the script `{path}` cannot be used\n{error}")))
}

fn today() -> Calendar {
    let since = SystemTime::now().duration_since(SystemTime::UNIX_EPOCH);
    since.map_or_else(|_| Calendar::default(), |since| Calendar::starting_at_unix(since.as_secs()))
}

fn worded(fault: &ScriptFault) -> String {
    format!("  t = {}: {}", fault.seconds, fault.with_proposals())
}
