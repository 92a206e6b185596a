//! The offers that assists make for a place.

use crate::edit::SourceChange;

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
    /// Which one, for [`resolve_assist`](crate::resolve_assist).
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

/// The result: all offers, or the change of one.
pub(crate) struct Assists<'a> {
    only: Option<&'a [AssistKind]>,
    wanted: Option<&'a str>,
    found: Vec<Assist>,
    change: Option<SourceChange>,
}

impl<'a> Assists<'a> {
    /// Collects the offers; `only` leaves out other kinds.
    pub(super) fn offers(only: Option<&'a [AssistKind]>) -> Self {
        Self { only, wanted: None, found: Vec::new(), change: None }
    }

    /// Computes the change of the assist `id`.
    pub(super) fn change_of(id: &'a str) -> Self {
        Self { only: None, wanted: Some(id), found: Vec::new(), change: None }
    }

    /// The offers, in the order of the handlers.
    pub(super) fn into_found(self) -> Vec<Assist> {
        self.found
    }

    /// The change of the wanted assist, if it is offered.
    pub(super) fn into_change(self) -> Option<SourceChange> {
        self.change
    }

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
