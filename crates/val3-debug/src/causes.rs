//! Causes of run-time errors: the data in the failed line that the error is about.

use val3_lang::fault::Fault;
use val3_lang::ports::TaskNumber;
use val3_lang::runtime_errors::{INDEX_NEGATIVE, INDEX_TOO_LARGE, UNLINKED};
use val3_machine::controller::Controller;

use crate::unlinked::unlinked;

/// Returns sentences about the data with which a run-time error has stopped a task: variables without a signal, or the
/// missing element of an array or collection. Empty for other errors.
#[must_use]
pub fn causes(controller: &mut Controller, task: TaskNumber, fault: Fault) -> Vec<String> {
    match fault.0 {
        UNLINKED => unlinked(controller, task).iter().map(ToString::to_string).collect(),
        INDEX_TOO_LARGE | INDEX_NEGATIVE => controller.vm.failed_access(task).iter().map(ToString::to_string).collect(),
        _ => Vec::new(),
    }
}
