//! Code actions: what a person may want done at a place, offered where it can be done. One a file.

mod context;
mod create_global;
mod create_local;
mod create_parameter;
mod create_program;
mod expected;
mod extract_program;
mod fixes;
mod if_to_switch;
mod inline_program;
mod lines;
mod missing_items;
mod name_number;
mod offers;
mod sort_programs;
mod surround;
mod switch_to_if;
mod toggle_access;
mod wait_for_arm;

#[cfg(test)]
mod testing;
#[cfg(test)]
pub(crate) use testing::shown;

use val3_analysis::db::{Db, FileRange};

use crate::edit::SourceChange;
use context::Context;

pub use fixes::{FixContext, QuickFix, fix_all, quick_fixes};
pub(crate) use offers::Assists;
pub use offers::{Assist, AssistKind};

/// Offers assists for a place. The edits of an assist are computed only when it is chosen.
type Handler = fn(&Context<'_>, &mut Assists<'_>) -> Option<()>;

/// Every assist, fixes first.
const HANDLERS: &[Handler] = &[
    create_local::offer,
    create_parameter::offer,
    create_global::offer,
    create_program::offer,
    missing_items::offer,
    wait_for_arm::offer,
    name_number::offer,
    extract_program::offer,
    inline_program::offer,
    if_to_switch::offer,
    switch_to_if::offer,
    surround::offer,
    toggle_access::offer,
    sort_programs::offer,
];

/// The assists at a cursor, if the range is empty, or for a selection. `only` leaves out
/// other kinds.
pub fn assists(db: &dyn Db, at: FileRange, only: Option<&[AssistKind]>) -> Vec<Assist> {
    collect(db, at, Assists::offers(only)).into_found()
}

/// The changes of an assist; `None` if it is not offered at this place, or has nothing to change.
pub fn resolve_assist(db: &dyn Db, id: &str, at: FileRange) -> Option<SourceChange> {
    let found = collect(db, at, Assists::change_of(id));
    Some(found.into_change()?.sorted(db))
}

fn collect<'a>(db: &dyn Db, at: FileRange, mut found: Assists<'a>) -> Assists<'a> {
    if let Some(context) = Context::new(db, at) {
        for handler in HANDLERS {
            // A handler that ends early has nothing more to offer.
            let _ = handler(&context, &mut found);
        }
    }
    found
}
