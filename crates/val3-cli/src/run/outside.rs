//! What happens to an application from outside while it runs: the operator, and what a script says.

use std::fs;
use std::time::SystemTime;

use camino::Utf8Path;
use val3_machine::controller::Controller;
use val3_machine::controller_state::Calendar;
use val3_machine::script::Script;

use crate::args::RunArgs;
use crate::user_error::UserError;

/// Lets the operator, the script and the calendar on the wall do the part that the arguments give them.
///
/// # Errors
/// The script cannot be read, or says what no script can say.
pub(super) fn arrange(controller: &mut Controller, args: &RunArgs) -> Result<(), UserError> {
    if let Some(path) = &args.script {
        controller.follow(script(path)?);
    }
    controller.devices.pendant.type_when_asked(args.keys.iter().copied());
    if args.follows_wall() && args.controller.date.is_none() {
        controller.devices.calendar = today();
    }
    Ok(())
}

fn today() -> Calendar {
    let since = SystemTime::now().duration_since(SystemTime::UNIX_EPOCH);
    since.map_or_else(|_| Calendar::default(), |since| Calendar::starting_at_unix(since.as_secs()))
}

fn script(path: &Utf8Path) -> Result<Script, UserError> {
    let text = fs::read_to_string(path).map_err(|error| {
        UserError::new(format!("cannot read the script `{path}`: {error}"))
            .with_help("name a TOML file with an [[at]] for each time at which something happens")
    })?;
    Script::parse(&text).map_err(|error| UserError::new(format!("the script `{path}` cannot be used\n{error}")))
}
