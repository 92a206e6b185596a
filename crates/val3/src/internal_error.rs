//! Reports of bugs of the tools: a message for each place in the code, on standard error.

use std::collections::BTreeSet;
use std::sync::{Mutex, PoisonError};

use val3_syntax::{Bug, set_bug_hook};

use crate::output::to_stderr;

/// Lines and columns of the source code whose report was written. A loop would fill the screen otherwise.
static REPORTED: Mutex<BTreeSet<(&str, u32, u32)>> = Mutex::new(BTreeSet::new());

/// Connects the hook of [`val3_syntax::never`] with standard error, which editors show in the log of the server.
pub(crate) fn connect() {
    set_bug_hook(report);
}

fn report(bug: &Bug<'_>) {
    let place = (bug.location.file(), bug.location.line(), bug.location.column());
    if REPORTED.lock().unwrap_or_else(PoisonError::into_inner).insert(place) {
        to_stderr(|out| writeln!(out, "{bug}"));
    }
}
