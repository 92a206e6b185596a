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

/// The computation of an answer, which is JSON.
pub(crate) type Compute = Arc<dyn Fn(&Snapshot) -> Result<String> + Send + Sync>;

/// Handling of a request when an edit changes its subject before it is answered.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum OnEdit {
    /// Its position means another place now: ContentModified.
    Refuse,
    /// The request is about the current document. It is computed again.
    Retry,
}
