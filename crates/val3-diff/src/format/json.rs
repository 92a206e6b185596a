//! JSON format for programs: the list of changes as one document.

use serde::Serialize;

use crate::model::{Comparison, Ignored, Problem};
use crate::report::{Detail, DiffStatistics, DifferenceCounts, statistics};

/// Version of the document format. It changes only if a field is removed or its meaning changes.
const VERSION: u32 = 1;

#[derive(Serialize)]
struct Document<'a, C: Serialize> {
    version: u32,
    different: bool,
    summary: DifferenceCounts,
    #[serde(flatten)]
    content: &'a C,
}

/// Content with numbers instead of differences.
#[derive(Serialize)]
struct Numbers<'a> {
    old: &'a str,
    new: &'a str,
    compared: usize,
    statistics: Vec<DiffStatistics>,
    ignored: &'a Ignored,
    problems: &'a [Problem],
}

/// Writes the document, with a line end.
///
/// # Errors
/// Never for a comparison of this crate, because all its values can be serialised.
pub fn write(comparison: &Comparison, detail: Detail) -> Result<String, serde_json::Error> {
    let text = match detail {
        Detail::Full => document(comparison, comparison),
        Detail::Statistics => {
            let Comparison { old, new, compared, ignored, problems, .. } = comparison;
            let statistics = statistics(comparison);
            document(comparison, &Numbers { old, new, compared: *compared, statistics, ignored, problems })
        }
    };
    text.map(|text| text + "\n")
}

fn document(comparison: &Comparison, content: &impl Serialize) -> Result<String, serde_json::Error> {
    let different = !comparison.is_empty();
    serde_json::to_string_pretty(&Document {
        version: VERSION,
        different,
        summary: DifferenceCounts::of(comparison),
        content,
    })
}
