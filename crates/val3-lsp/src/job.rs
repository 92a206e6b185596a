//! A request that is ready to be computed.

use std::sync::Arc;

use tower_lsp::jsonrpc::Result;

use crate::pool::Priority;
use crate::snapshot::Snapshot;

/// A request, read and ready to be computed; more than once, if edits come in between.
#[derive(Clone)]
pub(crate) struct Job {
    /// Its method, for messages.
    pub(crate) method: &'static str,
    /// Where it is computed.
    pub(crate) priority: Priority,
    /// Handling of a change of the text meanwhile.
    pub(crate) on_edit: OnEdit,
    /// Gives the answer.
    pub(crate) compute: Compute,
}

/// The computation of an answer, which is JSON; `None` if only a part of it has been computed.
pub(crate) type Compute = Arc<dyn Fn(&Snapshot) -> Result<Option<String>> + Send + Sync>;

/// The outcome of a request that is computed in parts, so that data of one part are freed before the next.
#[derive(Debug)]
pub(crate) enum Part<T> {
    /// The answer.
    Last(T),
    /// The request is computed again; the database keeps the results of this part.
    More,
}

/// Handling of a request when an edit changes its subject before it is answered.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum OnEdit {
    /// Its position means another place now: ContentModified.
    Refuse,
    /// The request is about the current document. It is computed again.
    Retry,
}
