//! Offers of assists at a position.

use crate::RefactoringError;
use crate::edit::SourceChange;

/// Assist kind, by which editors group.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum AssistKind {
    /// Fixes a finding.
    QuickFix,
    /// Extracts code into a new item.
    Extract,
    /// Replaces uses by the used code or value.
    Inline,
    /// Rewrites code in another form.
    Rewrite,
    /// Sorts a list.
    Organise,
}

/// An offered assist.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Assist {
    /// Identifier for [`resolve_assist`](crate::resolve_assist).
    pub id: &'static str,
    /// Kind.
    pub kind: AssistKind,
    /// Title, in the imperative.
    pub title: String,
    /// Title of a group: assists with the same group are shown as one action with choices.
    pub group: Option<&'static str>,
    /// Reason why the assist is disabled, as a sentence for the user; `None` if it can be applied.
    pub disabled: Option<String>,
}

/// Collected offers, or the change made by the requested assist.
pub(crate) struct Assists<'a> {
    only: Option<&'a [AssistKind]>,
    wanted: Option<&'a str>,
    found: Vec<Assist>,
    change: Option<SourceChange>,
}

impl<'a> Assists<'a> {
    /// Collects the offers; if `only` is set, other kinds are omitted.
    pub(super) fn offers(only: Option<&'a [AssistKind]>) -> Self {
        Self { only, wanted: None, found: Vec::new(), change: None }
    }

    /// Computes the change of the assist `id`.
    pub(super) fn change_of(id: &'a str) -> Self {
        Self { only: None, wanted: Some(id), found: Vec::new(), change: None }
    }

    /// Offers, in the order of the handlers.
    pub(super) fn into_found(self) -> Vec<Assist> {
        self.found
    }

    /// Change of the requested assist, if it is offered.
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

    /// Offers an assist as part of a group.
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

    /// Offers a disabled assist with the reason, because it would break the code.
    pub(crate) fn refuse(
        &mut self,
        group: Option<&'static str>,
        id: &'static str,
        kind: AssistKind,
        title: impl Into<String>,
        reason: impl Into<RefactoringError>,
    ) {
        if self.wanted.is_none() {
            self.show(Assist { id, kind, title: title.into(), group, disabled: Some(reason.into().0) });
        }
    }

    fn show(&mut self, assist: Assist) {
        if self.only.is_none_or(|only| only.contains(&assist.kind)) {
            self.found.push(assist);
        }
    }
}
