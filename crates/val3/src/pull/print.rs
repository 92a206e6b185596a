//! `val3 pull --print`: one file of the controller on the standard output, for a comparison in an editor.

use std::process::ExitCode;

use val3_controller::{ControllerPath, ControllerProject, check_identity, read_file};

use crate::color::Color;
use crate::controller::ControllerTarget;
use crate::output::{OutputContent, to_stdout_as};
use crate::user_error::UserError;

/// Prints the file. Nothing is written, so that a push that was killed is not recovered.
pub(super) fn run(
    path: &str,
    project: &ControllerProject,
    mut target: ControllerTarget,
    accepts_new: bool,
) -> Result<ExitCode, UserError> {
    let path = ControllerPath::parse(path).map_err(|fault| {
        UserError::new(fault.to_string()).with_help("name a file as `val3 status` does: usr/usrapp/demo/start.pgx")
    })?;
    let mut files = target.connect()?;
    check_identity(project, &target.address, &mut *files, accepts_new)?;
    let bytes = read_file(&mut *files, &path)?;
    to_stdout_as(OutputContent::File, Color::Never, |out| out.write_all(&bytes))?;
    Ok(ExitCode::SUCCESS)
}
