//! What an application finds around it: the inputs and outputs of its cell, the operator, and what a script says.

use std::fs;
use std::time::SystemTime;

use camino::Utf8Path;
use val3_analysis::db::{Database, Project};
use val3_lang::components::Component;
use val3_machine::controller::Controller;
use val3_machine::controller_state::Calendar;
use val3_machine::devices::Devices;
use val3_machine::script::Script;
use val3_syntax::encoding::decode;

use crate::args::RunArgs;
use crate::user_error::UserError;

/// Declares the inputs and outputs that the configuration of the cell names.
pub(super) fn declare_io(devices: &mut Devices, db: &Database, project: Project) {
    let Some(cell) = project.cell(db) else { return };
    for (device, signals) in &cell.config(db).io {
        let mut signals: Vec<_> = signals.iter().map(|(name, base)| (name.as_str(), *base)).collect();
        signals.sort_unstable_by_key(|(name, _)| *name);
        devices.declare_io(device, signals);
    }
}

/// Tells the controller what the cell around `disk` and the arguments say of it: arm, language and date.
pub(super) fn describe(devices: &mut Devices, disk: &Utf8Path, args: &RunArgs) {
    for name in ["arm.cfx", "cell.cfx"] {
        if let Some(text) = config(disk, name) {
            devices.describe(&text);
        }
    }
    // Kinds of arms have no digit, models have.
    if let Some(model) = args.arm.as_ref().filter(|name| name.contains(|letter: char| letter.is_ascii_digit())) {
        devices.versions.set(Component::ArmType, model);
    }
    if let Some(date) = args.date.or_else(|| args.follows_wall().then(today)) {
        devices.calendar = date;
    }
}

/// The text of a file in `usr/configs` of the cell around `disk`, if it is there.
pub(super) fn config(disk: &Utf8Path, name: &str) -> Option<String> {
    let bytes = fs::read(disk.parent()?.join("configs").join(name)).ok()?;
    Some(decode(bytes).text)
}

fn today() -> Calendar {
    let since = SystemTime::now().duration_since(SystemTime::UNIX_EPOCH);
    since.map_or_else(|_| Calendar::default(), |since| Calendar::starting_at_unix(since.as_secs()))
}

/// Lets the operator and the script of the arguments do their part.
///
/// # Errors
/// The script cannot be read, or says what no script can say.
pub(super) fn arrange(controller: &mut Controller, args: &RunArgs) -> Result<(), UserError> {
    if let Some(path) = &args.script {
        controller.follow(script(path)?);
    }
    controller.devices.pendant.type_when_asked(args.keys.iter().copied());
    Ok(())
}

fn script(path: &Utf8Path) -> Result<Script, UserError> {
    let text = fs::read_to_string(path).map_err(|error| {
        UserError::new(format!("cannot read the script `{path}`: {error}"))
            .with_help("name a TOML file with an [[at]] for each time at which something happens")
    })?;
    Script::parse(&text).map_err(|error| UserError::new(format!("the script `{path}` cannot be used\n{error}")))
}
