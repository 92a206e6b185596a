//! For programs: the list of changes as one JSON document.

use serde::Serialize;

use crate::model::Comparison;
use crate::report::Counts;

/// The form of the document. It changes only when a field is removed or gets another meaning.
const VERSION: u32 = 1;

#[derive(Serialize)]
struct Document<'a> {
    version: u32,
    different: bool,
    summary: Counts,
    #[serde(flatten)]
    comparison: &'a Comparison,
}

/// The document, with a line end.
///
/// # Errors
/// Never for a comparison of this crate, whose values all have a form in JSON.
pub fn write(comparison: &Comparison) -> Result<String, serde_json::Error> {
    let different = !comparison.is_empty();
    let document = Document { version: VERSION, different, summary: Counts::of(comparison), comparison };
    serde_json::to_string_pretty(&document).map(|text| text + "\n")
}
