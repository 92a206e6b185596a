//! `explain`: a page of the documentation, or a search in all pages.

use schemars::JsonSchema;
use serde::Deserialize;
use serde_json::Value;

use crate::answer::Answer;
use crate::command::{CommandRequest, OF_RUNS};
use crate::refusal::Refusal;
use crate::report::{items, text};
use crate::tool::{Call, Definition};

/// The tool.
pub(super) struct Explain;

/// Topic of the primer.
pub(crate) const GUIDE: &str = "guide";

/// Arguments.
#[derive(Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub(super) struct Arguments {
    /// Instruction (movej), finding (V0203), run-time error (20), type, keyword, word of the field, or words to search;
    /// `guide` for the primer of the language
    topic: String,
    /// Up to 24 kB instead of 8 kB
    #[serde(default)]
    detail: bool,
}

impl Definition for Explain {
    const NAME: &'static str = "explain";
    const TITLE: &'static str = "Explain VAL 3";
    const DESCRIPTION: &'static str = "Returns the page of a VAL 3 instruction, finding, run-time error, type or word, \
        or searches all pages. The pages list every instruction with its signatures: an instruction without a page does \
        not exist.";
    type Arguments = Arguments;

    fn call(call: &Call<'_>, arguments: Arguments) -> Result<Answer, Refusal> {
        let Arguments { topic, detail } = arguments;
        page(call, &topic).map(|answer| answer.with_detail(detail))
    }
}

/// Returns the page of a topic, or the pages that contain its words.
pub(crate) fn page(call: &Call<'_>, topic: &str) -> Result<Answer, Refusal> {
    let topic = topic.trim();
    if topic == GUIDE {
        let output = call.command(&CommandRequest::new(["guide"], OF_RUNS))?;
        return Ok(Answer::new(true, output.text));
    }
    if topic.is_empty() || topic.starts_with('-') {
        return Err(Refusal::new("`topic` must be a word, such as `movej`, `V0203`, `20` or `guide`"));
    }
    let document = call.report(&CommandRequest::new(["explain", "--format", "json", topic], OF_RUNS))?.document;
    let pages = items(&document, "pages");
    let is_search = pages.iter().any(|page| page.get("excerpt").is_some_and(|excerpt| !excerpt.is_null()));
    Ok(Answer::new(true, if is_search { hits(topic, pages) } else { whole(pages) }))
}

fn whole(pages: &[Value]) -> String {
    pages.iter().map(|page| text(page, "page")).collect::<Vec<_>>().join("\n")
}

/// Number of pages that a search lists.
const HITS: usize = 8;

fn hits(topic: &str, pages: &[Value]) -> String {
    let lines: Vec<String> = pages.iter().take(HITS).map(hit).collect();
    format!("there is no page `{topic}`; pages that contain it, best first:\n{}", lines.join("\n"))
}

/// Line of a page in a search's list: its first name, summary, and the text around the hit outside of the summary.
fn hit(page: &Value) -> String {
    let name = items(page, "names").first().and_then(Value::as_str).unwrap_or_default();
    let (kind, summary, excerpt) = (text(page, "kind"), text(page, "summary"), text(page, "excerpt"));
    let excerpt = if excerpt == summary || excerpt.is_empty() { String::new() } else { format!(" … {excerpt}") };
    format!("- `{name}` ({kind}): {summary}{excerpt}")
}
