//! A page of the book.

use val3_check::topics::Kind;

/// A page, before or after its links are added.
#[derive(Debug, Clone)]
pub(crate) struct Page {
    /// Path relative to `src`.
    pub(crate) path: String,
    /// The subject of a generated page.
    pub(crate) subject: Option<Subject>,
    /// Markdown.
    pub(crate) text: String,
}

/// The subject of a page of the reference.
#[derive(Debug, Clone)]
pub(crate) struct Subject {
    /// Its kind.
    pub(crate) kind: Kind,
    /// The first word that finds it.
    pub(crate) name: String,
}

impl Page {
    /// A page that is no topic.
    pub(crate) fn plain(path: impl Into<String>, text: impl Into<String>) -> Self {
        Self { path: path.into(), subject: None, text: text.into() }
    }

    /// The kind of its subject.
    pub(crate) fn kind(&self) -> Option<Kind> {
        self.subject.as_ref().map(|subject| subject.kind)
    }

    /// The relative address of another page.
    pub(crate) fn link_to(&self, other: &str) -> String {
        format!("{}{other}", "../".repeat(self.path.matches('/').count()))
    }
}
