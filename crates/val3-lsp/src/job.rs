//! A parsed request, ready to be computed.

use std::sync::Arc;

use tower_lsp::jsonrpc::Result;

use crate::pool::Priority;
use crate::snapshot::Snapshot;

/// A parsed request. It is computed again if an edit cancels the computation.
#[derive(Clone)]
pub(crate) struct Job {
    /// Method name, for messages.
    pub(crate) method: &'static str,
    /// Priority of the thread that computes it.
    pub(crate) priority: Priority,
    /// Handling of edits during the computation.
    pub(crate) on_edit: OnEdit,
    /// Computation of the response.
    pub(crate) compute: Compute,
}

/// Function that computes the result as JSON; `None` if only a part has been computed.
pub(crate) type Compute = Arc<dyn Fn(&Snapshot) -> Result<Option<String>> + Send + Sync>;

/// Outcome of a request that is computed in parts. The data of a completed part are freed before the next part.
#[derive(Debug)]
pub(crate) enum JobPart<T> {
    /// Final result.
    Last(T),
    /// A part is complete and the request is computed again; the database keeps the results of this part.
    More,
}

/// Handling of a request if an edit changes its document before the response.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum OnEdit {
    /// The position is no longer valid: `ContentModified` is returned.
    Refuse,
    /// The request concerns the current document and is computed again.
    Retry,
}
