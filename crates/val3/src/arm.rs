//! `val3 arm`: lists, shows and converts arms, and measures their times.

mod files;
mod fit;
mod list;
mod measure;
mod show;
mod urdf;

use std::process::ExitCode;

use crate::args::{ArmAction, ArmArgs};
use crate::color::Color;
use crate::user_error::UserError;

/// Runs the command.
pub(crate) fn run(args: &ArmArgs, color: Color) -> Result<ExitCode, UserError> {
    match &args.action {
        ArmAction::List(_) => list::run(color).map(|()| ExitCode::SUCCESS),
        ArmAction::Show(show) => show::run(show, color).map(|()| ExitCode::SUCCESS),
        ArmAction::Urdf(urdf) => urdf::run(urdf, color).map(|()| ExitCode::SUCCESS),
        ArmAction::Measure(measure) => measure::run(measure).map(|()| ExitCode::SUCCESS),
        ArmAction::Fit(fit) => fit::run(fit, color),
    }
}
