//! Displayed contents other than diagnostics that edits of other files may change.

use std::hash::{Hash as _, Hasher as _};

use rustc_hash::{FxHashMap, FxHasher};
use serde::Serialize;
use tower_lsp::lsp_types::{Range, Url};

/// Latest responses sent to the client, by document.
#[derive(Debug, Default)]
pub(crate) struct DisplayCache {
    by_uri: FxHashMap<Url, DisplayedDocument>,
    /// Texts that the server generates for files.
    texts: FxHashMap<Url, Fingerprint>,
}

/// Displayed contents for one document.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(crate) struct DisplayedDocument {
    /// Document version for which the contents were computed.
    pub(crate) version: i32,
    /// Range and fingerprint of the inlay hints.
    pub(crate) hints: Option<(Range, Fingerprint)>,
    /// Fingerprint of the code lenses' ranges.
    pub(crate) lenses: Option<Fingerprint>,
    /// Visible code lenses by range, with their usage counts.
    pub(crate) uses: Vec<(Range, usize)>,
}

/// Hash of a response: equal for equal responses.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) struct Fingerprint(u64);

impl Fingerprint {
    /// Fingerprint of a response. Responses are serialisable, so writing one as JSON does not fail; a failure would
    /// count as a change.
    pub(crate) fn of(answer: &impl Serialize) -> Self {
        let mut hasher = FxHasher::default();
        serde_json::to_string(answer).unwrap_or_default().hash(&mut hasher);
        Self(hasher.finish())
    }
}

impl DisplayCache {
    /// Mutable displayed contents for one document version. They are reset if they belong to another version.
    pub(crate) fn entry(&mut self, uri: &Url, version: i32) -> &mut DisplayedDocument {
        let nothing = || DisplayedDocument { version, hints: None, lenses: None, uses: Vec::new() };
        let shown = self.by_uri.entry(uri.clone()).or_insert_with(nothing);
        if shown.version != version {
            *shown = nothing();
        }
        shown
    }

    /// Replaces the displayed contents of a document.
    pub(crate) fn keep(&mut self, uri: Url, shown: DisplayedDocument) {
        self.by_uri.insert(uri, shown);
    }

    /// Removes a closed document.
    pub(crate) fn forget(&mut self, uri: &Url) {
        self.by_uri.remove(uri);
    }

    /// Stores the fingerprint of a text that the client has received.
    pub(crate) fn keep_text(&mut self, uri: Url, text: Fingerprint) {
        self.texts.insert(uri, text);
    }

    /// Texts that the client has received.
    pub(crate) fn texts(&self) -> impl Iterator<Item = (&Url, &Fingerprint)> {
        self.texts.iter()
    }

    /// Whether the client has no contents that may become stale.
    pub(crate) fn is_empty(&self) -> bool {
        self.by_uri.is_empty() && self.texts.is_empty()
    }

    /// The documents.
    pub(crate) fn iter(&self) -> impl Iterator<Item = (&Url, &DisplayedDocument)> {
        self.by_uri.iter()
    }
}

impl DisplayedDocument {
    /// Stores the usage count of a lens.
    pub(crate) fn counted(&mut self, lens: Range, uses: usize) {
        match self.uses.iter_mut().find(|(range, _)| *range == lens) {
            Some((_, known)) => *known = uses,
            None => self.uses.push((lens, uses)),
        }
    }
}
