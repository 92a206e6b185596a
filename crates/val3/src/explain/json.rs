//! Pages of `val3 explain` as one JSON document.
//!
//! ```json
//! {"version": 1, "pages": [{"kind": "run-time error", "names": ["123"], "heading": "…", "summary": "…", "page": "…"}]}
//! ```
//! `page` is Markdown. `excerpt` is the best sentence of a page that a search has found.

use serde_json::{Value, json};
use val3_check::topics::Topic;

use super::{Answer, results};

/// Converts the result to a document.
pub(super) fn document(answer: &Answer<'_>) -> Value {
    let pages: Vec<Value> = match answer {
        Answer::Pages(pages) => pages.iter().map(|topic| page(topic, None)).collect(),
        Answer::Hits(hits) => hits.iter().map(|hit| page(hit.topic, Some(&hit.excerpt))).collect(),
    };
    json!({ "version": 1, "pages": pages })
}

fn page(topic: &Topic, excerpt: Option<&str>) -> Value {
    json!({
        "kind": results::kind(topic.kind),
        "names": topic.names,
        "heading": topic.title,
        "summary": topic.summary,
        "excerpt": excerpt,
        "page": topic.page,
    })
}
