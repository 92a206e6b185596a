//! `val3 arm measure`: an application that measures the times of an arm on its controller.

mod application;
mod data;

use std::fs;

use val3_kinematics::Arm;
use val3_session::ArmFile;

use crate::args::{ArmMeasureArgs, AxisRange};
use crate::output::to_stderr;
use crate::paths::current_folder;
use crate::user_error::UserError;

use super::files::{check_absent, write_file};

/// Minimum length of a range, in degrees or mm. Shorter moves take too few cycles.
const SHORTEST_RANGE: f64 = 5.0;

/// Maximum number of characters in an application name on CS8 controllers.
const LONGEST_NAME: usize = 15;

/// Runs the command.
pub(super) fn run(args: &ArmMeasureArgs) -> Result<(), UserError> {
    let arm = ArmFile::named(&args.arm)?.arm;
    check_ranges(&arm, &args.range)?;
    let folder = &args.folder;
    let absolute = current_folder()?.join(folder);
    let name = absolute.file_name().unwrap_or_default();
    check_name(name)?;
    let files = application::files(name, &arm, &args.range);
    if !args.force {
        files.iter().try_for_each(|(file, _)| check_absent(&folder.join(file)))?;
    }
    fs::create_dir_all(folder).map_err(|error| UserError::new(format!("cannot create `{folder}`: {error}")))?;
    files.iter().try_for_each(|(file, text)| write_file(&folder.join(file), text))?;
    to_stderr(|out| {
        writeln!(out, "wrote {folder}")?;
        writeln!(out, "  1. copy it to `usrapp` of the controller and start it in local or remote mode")?;
        writeln!(out, "  2. copy the event log: errors.log (CS8) or user.log (CS9)")?;
        writeln!(out, "  3. val3 arm fit LOG --arm {} --output my-arm.toml", args.arm)
    });
    Ok(())
}

/// Checks that `name` is a valid application name.
fn check_name(name: &str) -> Result<(), UserError> {
    let is_word = name.chars().all(|char| char.is_ascii_alphanumeric() || char == '_')
        && name.starts_with(|first: char| first.is_ascii_alphabetic());
    if is_word && name.len() <= LONGEST_NAME {
        return Ok(());
    }
    Err(UserError::new(format!("an application cannot have the name `{name}`"))
        .with_help(format!("name a folder with at most {LONGEST_NAME} letters, digits and `_`, such as `armTimes`")))
}

/// Checks that each axis has at most one range, and that the ranges are within the limits of the arm.
fn check_ranges(arm: &Arm, ranges: &[AxisRange]) -> Result<(), UserError> {
    for (place, range) in ranges.iter().enumerate() {
        let AxisRange { axis, from, to } = *range;
        let wrong = |message: String, help: String| Err(UserError::new(message).with_help(help));
        let Some(limits) = axis.checked_sub(1).and_then(|axis| arm.limits().get(axis)) else {
            return wrong(format!("axis {axis} does not exist"), format!("name an axis from 1 to {}", arm.axes()));
        };
        if ranges.iter().take(place).any(|other| other.axis == axis) {
            return wrong(format!("axis {axis} has two ranges"), "remove one of them".to_owned());
        }
        let unit = arm.unit(axis - 1);
        if from < limits.min || to > limits.max {
            return wrong(
                format!("the range from {from} to {to} exceeds the limits of axis {axis}"),
                format!("name positions from {} to {} {unit}", limits.min, limits.max),
            );
        }
        if to - from < SHORTEST_RANGE {
            return wrong(
                format!("the range of axis {axis} is {} {unit} long, too short to measure its times", to - from),
                format!("name at least {SHORTEST_RANGE} {unit}"),
            );
        }
    }
    Ok(())
}
