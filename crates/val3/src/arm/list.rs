//! `val3 arm list`: the shipped arms.

use std::io;

use codespan_reporting::term::termcolor::WriteColor;
use val3_kinematics::Arm;

use crate::color::Color;
use crate::markdown::{code_style, styled};
use crate::output::to_stdout;
use crate::user_error::UserError;

/// Runs the command.
pub(super) fn run(color: Color) -> Result<(), UserError> {
    let arms = Arm::names().map(Arm::by_name).collect::<Result<Vec<_>, _>>();
    let arms = arms.map_err(|unknown| UserError::new(unknown.to_string()))?;
    to_stdout(color, |out| list(&arms, out))
}

fn list(arms: &[Arm], out: &mut dyn WriteColor) -> io::Result<()> {
    writeln!(out, "{:<14} {:>7}  {:<12} {:<9} sources", "name", "reach", "axes", "times")?;
    for arm in arms {
        styled(&code_style(), &format!("{:<14}", arm.name()), out)?;
        let axes = if arm.is_scara() { "4 (SCARA)" } else { "6" };
        let times = if arm.has_measured_times() { "measured" } else { "model" };
        let reach = format!("{:.0} mm", arm.reach());
        writeln!(out, " {reach:>7}  {axes:<12} {times:<9} {}", arm.sources().join("; "))?;
    }
    Ok(())
}
