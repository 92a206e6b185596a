//! `--arm`: the arm of an application whose cell does not say it.

use camino::Utf8Path;
use salsa::Setter as _;
use val3_analysis::db::{Configuration, Database, Project};
use val3_config::ConfigFile;

use crate::user_error::UserError;

/// Lets the project be for the arm called `name`, whatever its configuration says.
///
/// # Errors
/// There is no such arm.
pub(crate) fn set(db: &mut Database, project: Project, name: &str) -> Result<(), UserError> {
    let wanted = ConfigFile::parse(Utf8Path::new(""), &format!("arm = {name:?}"));
    let arm = wanted.map_err(|error| UserError::new(error.message).with_help(error.help))?.config.arm;
    let mut file = project.configuration(db).map(|found| found.file(db).clone()).unwrap_or_default();
    file.config.arm = arm;
    let configuration = Configuration::new(db, file);
    project.set_configuration(db).to(Some(configuration));
    Ok(())
}
