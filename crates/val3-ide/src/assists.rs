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
mod sort_programs;
mod surround;
mod switch_to_if;
mod toggle_access;
mod trial;
mod wait_for_arm;

#[cfg(test)]
mod testing;
#[cfg(test)]
pub(crate) use testing::shown;

use val3_analysis::db::{Db, FileRange};

use crate::edit::SourceChange;
use context::Context;

pub use fixes::{FixContext, QuickFix, fix_all, quick_fixes};

/// The kind of an assist, by which editors group.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum AssistKind {
    /// It fixes a finding.
    QuickFix,
    /// It takes something out into a thing of its own.
    Extract,
    /// It puts something in where it is used.
    Inline,
    /// It writes something otherwise.
    Rewrite,
    /// It puts a list in order.
    Organise,
}

/// Something that can be done.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Assist {
    /// Which one, for [`resolve_assist`].
    pub id: &'static str,
    /// Its kind.
    pub kind: AssistKind,
    /// Its title, in the imperative.
    pub title: String,
    /// Assists with the same words here are shown as one with choices.
    pub group: Option<&'static str>,
    /// Why it cannot be done here, as a sentence for the user; `None` if it can.
    pub disabled: Option<String>,
}

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

/// The result: all offers, or the change of one.
pub(crate) struct Assists<'a> {
    only: Option<&'a [AssistKind]>,
    wanted: Option<&'a str>,
    found: Vec<Assist>,
    change: Option<SourceChange>,
}

impl Assists<'_> {
    /// Offers an assist.
    pub(crate) fn add(
        &mut self,
        id: &'static str,
        kind: AssistKind,
        title: impl Into<String>,
        change: impl FnOnce() -> Option<SourceChange>,
    ) {
        self.add_in(None, id, kind, title, change);
    }

    /// Offers an assist as one of a group.
    pub(crate) fn add_in(
        &mut self,
        group: Option<&'static str>,
        id: &'static str,
        kind: AssistKind,
        title: impl Into<String>,
        change: impl FnOnce() -> Option<SourceChange>,
    ) {
        match self.wanted {
            Some(wanted) if wanted == id && self.change.is_none() => self.change = change(),
            Some(_) => {}
            None => self.show(Assist { id, kind, title: title.into(), group, disabled: None }),
        }
    }

    /// Shows an assist that would break something here, with the reason.
    pub(crate) fn refuse(
        &mut self,
        group: Option<&'static str>,
        id: &'static str,
        kind: AssistKind,
        title: impl Into<String>,
        reason: String,
    ) {
        if self.wanted.is_none() {
            self.show(Assist { id, kind, title: title.into(), group, disabled: Some(reason) });
        }
    }

    fn show(&mut self, assist: Assist) {
        if self.only.is_none_or(|only| only.contains(&assist.kind)) {
            self.found.push(assist);
        }
    }
}

/// The assists at a cursor, if the range is empty, or for a selection. `only` leaves out
/// other kinds.
pub fn assists(db: &dyn Db, at: FileRange, only: Option<&[AssistKind]>) -> Vec<Assist> {
    collect(db, at, Assists { only, wanted: None, found: Vec::new(), change: None }).found
}

/// The changes of an assist; `None` if it is not offered at this place, or has nothing to change.
pub fn resolve_assist(db: &dyn Db, id: &str, at: FileRange) -> Option<SourceChange> {
    let found = collect(db, at, Assists { only: None, wanted: Some(id), found: Vec::new(), change: None });
    Some(found.change?.sorted(db))
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
