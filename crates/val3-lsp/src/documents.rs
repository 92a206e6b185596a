//! Documents open in the client, whose texts replace the stored files.

use std::sync::{Arc, Mutex, MutexGuard, PoisonError};

use camino::{Utf8Path, Utf8PathBuf};
use rustc_hash::FxHashMap;
use tower_lsp::lsp_types::{SemanticTokens, TextDocumentContentChangeEvent, Url};
use val3_analysis::paths::path_key;
use val3_lines::ColumnUnit;

use crate::display_cache::DisplayCache;
use crate::lines::byte_range;
use crate::requests::data::KeptTables;

/// An open document.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(crate) struct Document {
    /// URI in the client's spelling.
    pub(crate) uri: Url,
    /// Path of the file, which need not exist.
    pub(crate) path: Utf8PathBuf,
    /// Text version, counted by the client.
    pub(crate) version: i32,
    /// Text.
    pub(crate) text: Arc<str>,
}

/// Findings of a document that the client has.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(crate) struct SentFindings {
    /// Document version of the findings.
    pub(crate) version: i32,
    /// Result id: equal for equal findings.
    pub(crate) id: String,
}

/// Open documents, and the contents that the client has cached for them.
#[derive(Debug, Clone, Default)]
pub(crate) struct Documents {
    by_uri: FxHashMap<Url, Document>,
    /// URI of the document that determines a file's text, by path key. If several documents name one file, it is the
    /// last one opened.
    by_path: FxHashMap<String, Url>,
    /// Semantic tokens that the client has, by document. All snapshots share them, because clients request the
    /// difference from the last response.
    tokens: Arc<Mutex<FxHashMap<Url, SemanticTokens>>>,
    /// Findings of the client's last pull, shared for the same reason.
    reports: Arc<Mutex<FxHashMap<Url, SentFindings>>>,
    /// Tables of data files that the client shows, shared for the same reason.
    tables: Arc<Mutex<FxHashMap<Url, KeptTables>>>,
    /// Inlay hints and code lenses that the client shows, shared for the same reason.
    display_cache: Arc<Mutex<DisplayCache>>,
}

impl Documents {
    /// Adds a document, or replaces the document with this URI.
    pub(crate) fn open(&mut self, document: Document) {
        self.by_path.insert(path_key(document.path.as_str()), document.uri.clone());
        self.by_uri.insert(document.uri.clone(), document);
    }

    /// Removes and returns a document.
    pub(crate) fn close(&mut self, uri: &Url) -> Option<Document> {
        let document = self.by_uri.remove(uri)?;
        let key = path_key(document.path.as_str());
        if self.by_path.get(&key) == Some(uri) {
            let other = self.by_uri.values().find(|other| path_key(other.path.as_str()) == key);
            match other.map(|other| other.uri.clone()) {
                Some(other) => _ = self.by_path.insert(key, other),
                None => _ = self.by_path.remove(&key),
            }
        }
        self.tokens().remove(uri);
        self.tables().remove(uri);
        self.lock_reports().remove(uri);
        self.display_cache().forget(uri);
        Some(document)
    }

    /// Document with this URI.
    pub(crate) fn get(&self, uri: &Url) -> Option<&Document> {
        self.by_uri.get(uri)
    }

    /// Like [`get`](Self::get), mutable.
    pub(crate) fn get_mut(&mut self, uri: &Url) -> Option<&mut Document> {
        self.by_uri.get_mut(uri)
    }

    /// Document that determines the text of the file at a path. Letter case is ignored.
    pub(crate) fn at(&self, path: &Utf8Path) -> Option<&Document> {
        self.by_uri.get(self.by_path.get(&path_key(path.as_str()))?)
    }

    /// Whether the document determines its file's text: no other document with the same path was opened later.
    pub(crate) fn is_effective(&self, document: &Document) -> bool {
        self.at(&document.path).is_some_and(|effective| effective.uri == document.uri)
    }

    /// Documents that determine their file's text.
    pub(crate) fn effective(&self) -> impl Iterator<Item = &Document> {
        self.by_path.values().filter_map(|uri| self.by_uri.get(uri))
    }

    /// Stores the semantic tokens sent to the client.
    pub(crate) fn keep_tokens(&self, uri: &Url, tokens: &SemanticTokens) {
        self.tokens().insert(uri.clone(), tokens.clone());
    }

    /// Semantic tokens last sent to the client.
    pub(crate) fn kept_tokens(&self, uri: &Url) -> Option<SemanticTokens> {
        self.tokens().get(uri).cloned()
    }

    /// Stores the tables sent to the client for an open document.
    pub(crate) fn keep_tables(&self, uri: &Url, tables: KeptTables) {
        if self.by_uri.contains_key(uri) {
            self.tables().insert(uri.clone(), tables);
        }
    }

    /// Tables last sent to the client.
    pub(crate) fn kept_tables(&self, uri: &Url) -> Option<KeptTables> {
        self.tables().get(uri).cloned()
    }

    fn tables(&self) -> MutexGuard<'_, FxHashMap<Url, KeptTables>> {
        self.tables.lock().unwrap_or_else(PoisonError::into_inner)
    }

    fn tokens(&self) -> MutexGuard<'_, FxHashMap<Url, SemanticTokens>> {
        self.tokens.lock().unwrap_or_else(PoisonError::into_inner)
    }

    /// Stores the findings sent to the client.
    pub(crate) fn keep_report(&self, uri: &Url, report: SentFindings) {
        self.lock_reports().insert(uri.clone(), report);
    }

    /// Findings last sent to the client, for all documents.
    pub(crate) fn reports(&self) -> Vec<(Url, SentFindings)> {
        self.lock_reports().iter().map(|(uri, report)| (uri.clone(), report.clone())).collect()
    }

    fn lock_reports(&self) -> MutexGuard<'_, FxHashMap<Url, SentFindings>> {
        self.reports.lock().unwrap_or_else(PoisonError::into_inner)
    }

    /// Inlay hints and code lenses that the client shows.
    pub(crate) fn display_cache(&self) -> MutexGuard<'_, DisplayCache> {
        self.display_cache.lock().unwrap_or_else(PoisonError::into_inner)
    }

    /// All open documents.
    pub(crate) fn iter(&self) -> impl Iterator<Item = &Document> {
        self.by_uri.values()
    }
}

impl Document {
    /// Applies the changes in order; each change applies to the result of the previous ones.
    pub(crate) fn change(&mut self, changes: Vec<TextDocumentContentChangeEvent>, encoding: ColumnUnit) {
        let mut text = String::from(&*self.text);
        for change in changes {
            match change.range {
                None => text = change.text,
                Some(range) => {
                    let range = byte_range(&text, range, encoding);
                    text.replace_range(range, &change.text);
                }
            }
        }
        self.text = text.into();
    }
}

#[cfg(test)]
mod tests {
    use tower_lsp::lsp_types::{Position, Range};

    use super::*;

    fn changed(text: &str, changes: &[(u32, u32, u32, u32, &str)]) -> String {
        let uri = Url::parse("file:///a.pgx").unwrap();
        let mut document = Document { uri, path: "/a.pgx".into(), version: 1, text: text.into() };
        let changes = changes.iter().map(|(line, column, to_line, to_column, text)| TextDocumentContentChangeEvent {
            range: Some(Range::new(Position::new(*line, *column), Position::new(*to_line, *to_column))),
            range_length: None,
            text: (*text).to_owned(),
        });
        document.change(changes.collect(), ColumnUnit::Utf16);
        document.text.to_string()
    }

    #[test]
    fn changes_are_applied_in_order() {
        assert_eq!(changed("a\nb\n", &[(0, 1, 1, 0, ""), (0, 2, 0, 2, "c")]), "abc\n");
        assert_eq!(changed("😀x", &[(0, 2, 0, 3, "é")]), "😀é");
    }

    #[test]
    fn changes_beyond_the_text_are_cut_to_it() {
        assert_eq!(changed("a", &[(9, 9, 12, 0, "b")]), "ab");
        assert_eq!(changed("abc", &[(0, 2, 0, 1, "")]), "ac");
        assert_eq!(changed("a\r\nb", &[(0, 9, 1, 0, "-")]), "a-b");
        assert_eq!(changed("a\nb\nc", &[(2, 0, 0, 1, "")]), "ac");
        assert_eq!(changed("a\n", &[(1, 0, 1, 0, "b"), (2, 0, 2, 0, "c")]), "a\nbc");
    }
}
