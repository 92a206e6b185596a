//! Count of visited nodes and tokens, for tests that limit the work of queries.

use std::cell::Cell;

thread_local! {
    static VISITS: Cell<u64> = const { Cell::new(0) };
}

/// Returns the number of nodes and tokens that this thread has visited. Builds without debug assertions do not count.
pub fn visits() -> u64 {
    VISITS.get()
}

pub(super) fn count_visit() {
    if cfg!(debug_assertions) {
        VISITS.set(VISITS.get() + 1);
    }
}
