//! Removal of applications, which a user may not intend: a folder can be missing by mistake.

use std::collections::BTreeSet;

use val3_controller::{ControllerPath, PushPlan};

use crate::controller::question::{can_ask, is_confirmed};
use crate::user_error::UserError;

/// Applications that a push removes.
pub(super) struct Removal {
    /// Removed applications, by their folders below `usr/usrapp`, that no option confirms.
    unconfirmed: Vec<String>,
}

impl Removal {
    /// Reads the names in `--remove`.
    ///
    /// # Errors
    /// The push does not remove an application of this name.
    pub(super) fn new(plan: &PushPlan, confirmed: &[String]) -> Result<Self, UserError> {
        let removed: BTreeSet<String> = plan.removed_applications.iter().map(name).collect();
        let confirmed: BTreeSet<&str> = confirmed.iter().map(|name| name.trim_end_matches('/')).collect();
        if let Some(unknown) = confirmed.iter().find(|name| !removed.contains(**name)) {
            let message = format!("--remove: the push does not remove the application `{unknown}`");
            return Err(UserError::new(message).with_help("`val3 push --dry-run` names the removed applications"));
        }
        Ok(Self { unconfirmed: removed.into_iter().filter(|name| !confirmed.contains(name.as_str())).collect() })
    }

    /// Note about what a push without `--dry-run` needs.
    pub(super) fn note(&self) -> Option<String> {
        let names = self.names()?;
        Some(format!("note: the push removes {names} from the controller, which needs {}", self.options()))
    }

    /// Reason why the push is refused; `None` if the user wants the removal.
    ///
    /// # Errors
    /// The answer cannot be read.
    pub(super) fn refusal(&self) -> Result<Option<UserError>, UserError> {
        let Some(names) = self.names() else { return Ok(None) };
        let remedy = format!("restore the local files with the `.pjx`, or add {}", self.options());
        if can_ask() {
            let is_wanted = is_confirmed(&format!("Remove {names} from the controller?"))?;
            return Ok((!is_wanted).then(|| UserError::new("nothing was pushed").with_help(remedy)));
        }
        let message = format!("the push would remove {names} from the controller");
        Ok(Some(UserError::new(message).with_help(remedy)))
    }

    /// The applications for a message; `None` if there are none.
    fn names(&self) -> Option<String> {
        let names = self.unconfirmed.iter().map(|name| format!("`{name}`")).collect::<Vec<_>>().join(", ");
        let noun = if self.unconfirmed.len() == 1 { "the application" } else { "the applications" };
        (!names.is_empty()).then(|| format!("{noun} {names}"))
    }

    fn options(&self) -> String {
        self.unconfirmed.iter().map(|name| format!("--remove {name}")).collect::<Vec<_>>().join(" ")
    }
}

/// Name of a folder below `usr/usrapp`.
fn name(folder: &ControllerPath) -> String {
    let applications = format!("{}/", ControllerPath::applications());
    folder.as_str().strip_prefix(&applications).unwrap_or(folder.as_str()).to_owned()
}
