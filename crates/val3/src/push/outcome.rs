//! Messages about the end of a push.

use val3_controller::{ControllerProject, FailureOutcome, PushFailure, PushPlan, RecoveryOutcome};

use crate::controller::{counted_files, note, shown, shown_bytes};
use crate::printable::one_line;
use crate::user_error::UserError;

/// Reports a complete push, and what has to be done on the controller.
pub(super) fn done(plan: &PushPlan, project: &ControllerProject) -> Result<(), UserError> {
    let uploads = plan.uploads().count();
    note(&format!(
        "pushed and verified: {} ({}), {} removed; backup in {}",
        counted_files(uploads),
        shown_bytes(plan.upload_bytes()),
        plan.changes.len() - uploads,
        shown(&project.folder().join(".val3/backup"))?
    ));
    let applications = plan.remaining_applications();
    if !applications.is_empty() {
        note(&format!("load on the controller again: {}", applications.join(", ")));
    }
    if plan.needs_restart() {
        note("restart the controller: it reads its settings and add-ons only when it starts");
    }
    Ok(())
}

/// Words a failed push: the cause, and the state of the controller.
pub(super) fn failed(failure: PushFailure) -> UserError {
    let cause = UserError::from(failure.error);
    match failure.outcome {
        FailureOutcome::Unchanged => cause.with_details("the applications on the controller were not changed"),
        FailureOutcome::Restored(RecoveryOutcome::Completed) => {
            cause.with_details("all new files are in place nevertheless: the push is complete")
        }
        FailureOutcome::Restored(RecoveryOutcome::Restored { count, kept }) => {
            let kept = kept.iter().map(|path| format!("; kept, because it was changed meanwhile: {path}"));
            cause.with_details(format!(
                "the old version of {} was restored{}",
                counted_files(count),
                kept.collect::<String>()
            ))
        }
        FailureOutcome::Restored(RecoveryOutcome::Cancelled) => {
            cause.with_details("the applications on the controller were not changed")
        }
        FailureOutcome::Unfinished { error, may_have_changed, backup } => {
            let state = match may_have_changed {
                true => "some files on the controller may be new and others old: do not load the application",
                false => "the applications on the controller were not changed, but temporary files remain",
            };
            cause
                .with_details(format!(
                    "{state}\nthe push could not be undone: {}\nbackup: {backup}",
                    one_line(&error.to_string())
                ))
                .with_help("as soon as the controller can be reached, run `val3 status`, which undoes the push")
        }
    }
}
