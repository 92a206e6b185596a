//! What an application finds around it: the inputs and outputs of its cell, the operator, and what a script says.

use std::fs;

use camino::Utf8Path;
use val3_analysis::db::{Database, Project};
use val3_machine::controller::Controller;
use val3_machine::devices::Devices;
use val3_machine::script::Script;

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

/// Lets the operator and the script of the arguments do their part.
///
/// # Errors
/// The script cannot be read, or says what no script can say.
pub(super) fn arrange(controller: &mut Controller, args: &RunArgs) -> Result<(), UserError> {
    if let Some(path) = &args.script {
        controller.follow(script(path)?);
    }
    controller.devices.pendant.type_when_asked(args.keys.iter().copied());
    if let Some(speed) = args.monitor_speed {
        controller.devices.robot.turn_speed(speed.into());
    }
    Ok(())
}

fn script(path: &Utf8Path) -> Result<Script, UserError> {
    let text = fs::read_to_string(path).map_err(|error| {
        UserError::new(format!("cannot read the script `{path}`: {error}"))
            .with_help("name a TOML file with an [[at]] for each time at which something happens")
    })?;
    Script::parse(&text).map_err(|error| UserError::new(format!("the script `{path}` cannot be used\n{error}")))
}
