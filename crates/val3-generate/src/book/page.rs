//! Pages of the book.

use val3_check::topics::TopicKind;

/// A page, before or after its links are added.
#[derive(Debug, Clone)]
pub(crate) struct BookPage {
    /// Path relative to `src`.
    pub(crate) path: String,
    /// Subject of a generated page.
    pub(crate) subject: Option<Subject>,
    /// Markdown.
    pub(crate) text: String,
}

/// Subject of a reference page.
#[derive(Debug, Clone)]
pub(crate) struct Subject {
    /// Kind.
    pub(crate) kind: TopicKind,
    /// First word that finds the page.
    pub(crate) name: String,
}

impl BookPage {
    /// Creates a page that is not a topic.
    pub(crate) fn plain(path: impl Into<String>, text: impl Into<String>) -> Self {
        Self { path: path.into(), subject: None, text: text.into() }
    }

    /// Returns the kind of the subject.
    pub(crate) fn kind(&self) -> Option<TopicKind> {
        self.subject.as_ref().map(|subject| subject.kind)
    }

    /// Returns the relative address for a link to the page at path `other`.
    pub(crate) fn link_to(&self, other: &str) -> String {
        format!("{}{other}", "../".repeat(self.path.matches('/').count()))
    }
}
