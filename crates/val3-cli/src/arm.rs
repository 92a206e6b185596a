//! `val3 arm`: arms, and the measurement of their times.

mod fit;
mod list;
mod measure;
mod show;

use std::fs;
use std::process::ExitCode;

use camino::Utf8Path;

use crate::args::{ArmAction, ArmArgs};
use crate::color::Color;
use crate::user_error::UserError;

/// Runs the command.
pub(crate) fn run(args: &ArmArgs, color: Color) -> Result<ExitCode, UserError> {
    match &args.action {
        ArmAction::List => list::run(color).map(|()| ExitCode::SUCCESS),
        ArmAction::Show(show) => show::run(show, color).map(|()| ExitCode::SUCCESS),
        ArmAction::Measure(measure) => measure::run(measure).map(|()| ExitCode::SUCCESS),
        ArmAction::Fit(fit) => fit::run(fit, color),
    }
}

/// Writes a text file.
fn write_file(path: &Utf8Path, text: &str) -> Result<(), UserError> {
    fs::write(path, text).map_err(|error| {
        UserError::new(format!("cannot write `{path}`: {error}"))
            .with_help("name a file in an existing folder that you may write to")
    })
}

/// Checks that no file would be replaced.
fn check_absent(path: &Utf8Path) -> Result<(), UserError> {
    // A dangling link is present, too.
    if fs::symlink_metadata(path).is_err() {
        return Ok(());
    }
    Err(UserError::new(format!("`{path}` exists")).with_help("--force replaces it"))
}

/// Unit of positions of an axis, counted from 0.
fn unit(arm: &val3_kinematics::Arm, axis: usize) -> &'static str {
    if arm.is_stroke(axis) { "mm" } else { "degrees" }
}
