//! Code actions: edits that are offered where they can be applied. One action is one file.

mod array_to_collection;
mod change_parameter;
mod collection_to_array;
mod container_uses;
mod context;
mod create_global;
mod create_local;
mod create_parameter;
mod create_program;
mod evaluation;
mod expected;
mod extract_program;
mod extract_variable;
mod fixes;
mod if_to_switch;
mod inline_program;
mod inline_variable;
mod invert_if;
mod libload_switch;
mod lines;
mod merge_if;
mod missing_cases;
mod missing_items;
mod name_number;
mod negation;
mod nested_if;
mod offers;
mod precedence;
mod program_header;
mod sort_programs;
mod split_if;
mod stability;
mod surround;
mod switch_to_if;
mod task_pair;
mod toggle_access;
mod wait_for_arm;

#[cfg(test)]
mod testing;
#[cfg(test)]
pub(crate) use testing::shown;

use val3_analysis::db::{Db, FileRange};

use crate::edit::SourceChange;
use context::Context;

pub(crate) use extract_variable::can_be_local;
pub(crate) use fixes::added_error;
pub use fixes::{FixContext, QuickFix, fix_all, quick_fixes};
pub(crate) use offers::Assists;
pub use offers::{Assist, AssistKind};
pub(crate) use program_header::header_comments;

/// Offers assists at a position. Edits are computed only when an assist is chosen.
type Handler = fn(&Context<'_>, &mut Assists<'_>) -> Option<()>;

/// All assists, quick fixes first.
const HANDLERS: &[Handler] = &[
    create_local::offer,
    create_parameter::offer,
    create_global::offer,
    create_program::offer,
    missing_items::offer,
    wait_for_arm::offer,
    task_pair::offer,
    libload_switch::offer,
    program_header::offer,
    name_number::offer,
    extract_program::offer,
    extract_variable::offer,
    inline_program::offer,
    inline_variable::offer,
    invert_if::offer,
    merge_if::offer,
    split_if::offer,
    if_to_switch::offer,
    switch_to_if::offer,
    missing_cases::offer,
    surround::offer,
    change_parameter::offer,
    toggle_access::offer,
    array_to_collection::offer,
    collection_to_array::offer,
    sort_programs::offer,
];

/// Assists at a cursor (empty range) or for a selection. If `only` is set, other kinds are omitted.
pub fn assists(db: &dyn Db, at: FileRange, only: Option<&[AssistKind]>) -> Vec<Assist> {
    collect(db, at, Assists::offers(only)).into_found()
}

/// Change made by an assist; `None` if it is not offered at this range or has nothing to change.
pub fn resolve_assist(db: &dyn Db, id: &str, at: FileRange) -> Option<SourceChange> {
    let found = collect(db, at, Assists::change_of(id));
    Some(found.into_change()?.sorted(db))
}

fn collect<'a>(db: &dyn Db, at: FileRange, mut found: Assists<'a>) -> Assists<'a> {
    if let Some(context) = Context::new(db, at) {
        for handler in HANDLERS {
            // A handler that returns early has no offer.
            let _ = handler(&context, &mut found);
        }
    }
    found
}
