//! `val3/page`: the page of a rule, an instruction, a statement or a run-time error, in Markdown.

use serde::{Deserialize, Serialize};
use tower_lsp::lsp_types::request::Request;
use val3_check::topics;

use crate::snapshot::{Refusal, Snapshot};

/// The request.
pub(crate) enum Page {}

impl Request for Page {
    type Params = PageParams;
    type Result = Option<PageResult>;
    const METHOD: &'static str = "val3/page";
}

/// The subject of the request.
#[derive(Debug, Deserialize, Serialize)]
pub(crate) struct PageParams {
    /// A code (`V0203`), the name of a rule, an instruction, a keyword or the number of a run-time error.
    topic: String,
}

/// The page.
#[derive(Debug, Serialize, Deserialize)]
pub(crate) struct PageResult {
    /// Its name in `val3 explain`.
    title: String,
    /// Markdown.
    markdown: String,
}

pub(crate) fn page(_: &Snapshot, params: &PageParams) -> Result<Option<PageResult>, Refusal> {
    let wanted = params.topic.trim();
    let is_meant = |topic: &topics::Topic| topic.names.iter().any(|name| name.eq_ignore_ascii_case(wanted));
    let mut found = topics::all().into_iter().filter(is_meant).peekable();
    let Some(title) = found.peek().and_then(|topic| topic.names.first()).cloned() else { return Ok(None) };
    let pages: Vec<String> = found.map(|topic| topic.page).collect();
    Ok(Some(PageResult { title, markdown: pages.join("\n\n") }))
}
