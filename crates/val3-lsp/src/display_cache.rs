//! Contents that clients show besides findings and that edits of other files may change.

use std::hash::{Hash as _, Hasher as _};

use rustc_hash::{FxHashMap, FxHasher};
use serde::Serialize;
use tower_lsp::lsp_types::{Range, Url};

/// The last answers that the client got, by document.
#[derive(Debug, Default)]
pub(crate) struct DisplayCache {
    by_uri: FxHashMap<Url, DisplayedDocument>,
    /// The texts that the server makes of files.
    texts: FxHashMap<Url, Fingerprint>,
}

/// The contents that are shown for one document.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(crate) struct DisplayedDocument {
    /// The version of the text that it belongs to.
    pub(crate) version: i32,
    /// The hints in a range.
    pub(crate) hints: Option<(Range, Fingerprint)>,
    /// The places of the lenses.
    pub(crate) lenses: Option<Fingerprint>,
    /// The lenses on the screen, by their lines, with their numbers of uses.
    pub(crate) uses: Vec<(Range, usize)>,
}

/// The same for the same answer.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) struct Fingerprint(u64);

impl Fingerprint {
    /// That of an answer. Answers are JSON, so that a fault of writing them does not occur; it would count as change.
    pub(crate) fn of(answer: &impl Serialize) -> Self {
        let mut hasher = FxHasher::default();
        serde_json::to_string(answer).unwrap_or_default().hash(&mut hasher);
        Self(hasher.finish())
    }
}

impl DisplayCache {
    /// The contents of one version of a document, to be changed. They are empty if they belong to another version.
    pub(crate) fn entry(&mut self, uri: &Url, version: i32) -> &mut DisplayedDocument {
        let nothing = || DisplayedDocument { version, hints: None, lenses: None, uses: Vec::new() };
        let shown = self.by_uri.entry(uri.clone()).or_insert_with(nothing);
        if shown.version != version {
            *shown = nothing();
        }
        shown
    }

    /// Replaces what is known about a document.
    pub(crate) fn keep(&mut self, uri: Url, shown: DisplayedDocument) {
        self.by_uri.insert(uri, shown);
    }

    /// The document was closed.
    pub(crate) fn forget(&mut self, uri: &Url) {
        self.by_uri.remove(uri);
    }

    /// The client has this text.
    pub(crate) fn keep_text(&mut self, uri: Url, text: Fingerprint) {
        self.texts.insert(uri, text);
    }

    /// The texts that the client has.
    pub(crate) fn texts(&self) -> impl Iterator<Item = (&Url, &Fingerprint)> {
        self.texts.iter()
    }

    /// The client has nothing that may become stale.
    pub(crate) fn is_empty(&self) -> bool {
        self.by_uri.is_empty() && self.texts.is_empty()
    }

    /// The documents.
    pub(crate) fn iter(&self) -> impl Iterator<Item = (&Url, &DisplayedDocument)> {
        self.by_uri.iter()
    }
}

impl DisplayedDocument {
    /// A lens shows a number of uses.
    pub(crate) fn counted(&mut self, lens: Range, uses: usize) {
        match self.uses.iter_mut().find(|(range, _)| *range == lens) {
            Some((_, known)) => *known = uses,
            None => self.uses.push((lens, uses)),
        }
    }
}
