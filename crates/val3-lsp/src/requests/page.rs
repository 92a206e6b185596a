//! `val3/page`: the page of a rule, an instruction, a type or another topic, in Markdown.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};
use tower_lsp::lsp_types::request::Request;
use val3_check::topics;

use crate::snapshot::{Refusal, Snapshot};

/// The request.
pub(crate) enum DocPage {}

impl Request for DocPage {
    type Params = PageParams;
    type Result = Option<PageResult>;
    const METHOD: &'static str = "val3/page";
}

/// Topic of the request.
#[derive(Debug, Deserialize, Serialize, JsonSchema)]
pub(crate) struct PageParams {
    /// A word that `val3 explain` accepts, for example a code (`V0203`), an instruction, a type or a run-time error
    /// number.
    topic: String,
}

/// The page.
#[derive(Debug, Serialize, Deserialize, JsonSchema)]
pub(crate) struct PageResult {
    /// Topic name in `val3 explain`.
    title: String,
    /// Page in Markdown.
    markdown: String,
}

pub(crate) fn page(_: &Snapshot, params: &PageParams) -> Result<Option<PageResult>, Refusal> {
    let wanted = params.topic.trim();
    let topics = topics::all();
    let found = topics::find(&topics, wanted);
    let Some(title) = found.first().map(|topic| topic.name().to_owned()) else { return Ok(None) };
    let pages: Vec<&str> = found.iter().map(|topic| topic.page.as_str()).collect();
    Ok(Some(PageResult { title, markdown: pages.join("\n\n") }))
}
