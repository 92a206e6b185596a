//! Contents that must not reach a controller, in files that the check does not read: marks of a merge, and settings that
//! are no XML.

use val3_controller::{ControllerPath, ControllerProject, PushPlan};
use val3_files::FileClass;
use val3_syntax::conflict::conflict_line;
use val3_syntax::document;
use val3_syntax::foreign::ForeignContent;

use crate::user_error::UserError;

/// Returns an error for each uploaded file with such a content.
///
/// # Errors
/// A file cannot be read.
pub(super) fn faults(project: &ControllerProject, plan: &PushPlan) -> Result<Vec<UserError>, UserError> {
    let mut faults = Vec::new();
    for change in plan.uploads() {
        let local = project.local(&change.path);
        let bytes = val3_files::read(&local, FileClass::Program)
            .map_err(|reason| UserError::new(format!("cannot read `{local}`: {reason}")))?;
        faults.extend(fault(&change.path, bytes));
    }
    Ok(faults)
}

fn fault(path: &ControllerPath, bytes: Vec<u8>) -> Option<UserError> {
    if let Some(line) = conflict_line(&bytes) {
        return Some(
            UserError::new(format!("`{path}`, line {line}: a merge conflict is not resolved"))
                .with_help("keep one of the versions, and remove the marks"),
        );
    }
    if ForeignContent::of(&bytes) == Some(ForeignContent::LfsPointer) {
        return Some(UserError::new(format!("`{path}`: {}", ForeignContent::LfsPointer)));
    }
    if !is_setting(path) {
        return None;
    }
    let fault = document::text(bytes).err()?;
    Some(
        UserError::new(format!("`{path}`: {fault}"))
            .with_help("repair it, or restore it: `.val3/base` contains the version of the last pull"),
    )
}

/// Whether the file is XML that the controller reads when it starts.
fn is_setting(path: &ControllerPath) -> bool {
    let name = path.name().to_ascii_lowercase();
    let is_xml = [".cfx", ".xml"].iter().any(|extension| name.ends_with(extension));
    is_xml && !path.is_in(&ControllerPath::applications())
}
