//! `test`: the tests of applications.

use schemars::JsonSchema;
use serde::Deserialize;
use serde_json::{Value, json};

use crate::answer::Answer;
use crate::command::{CommandRequest, OF_CELLS, Report};
use crate::refusal::Refusal;
use crate::report::{counted, items, notes, number, text};
use crate::tool::{Call, Definition};

/// The tool.
pub(super) struct Test;

/// Arguments.
#[derive(Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub(super) struct Arguments {
    /// Cell, test application, or file of a test
    #[serde(default = "crate::arguments::here")]
    path: String,
    /// Only tests whose names contain this text
    filter: Option<String>,
    /// Failures that are described; the others are counted. Default: 5
    max_failures: Option<usize>,
    /// Also the share of lines that the tests execute, for each program
    #[serde(default)]
    coverage: bool,
    /// Up to 24 kB instead of 8 kB
    #[serde(default)]
    detail: bool,
}

impl Definition for Test {
    const NAME: &'static str = "test";
    const TITLE: &'static str = "Test applications";
    const DESCRIPTION: &'static str = "Executes test programs (testName.pgx) and scenarios (tests/NAME.toml), each on a \
        separate virtual controller. Returns for each failure its line, both values, prints and the last events.";
    type Arguments = Arguments;

    fn call(call: &Call<'_>, arguments: Arguments) -> Result<Answer, Refusal> {
        let path = call.roots.resolve(&arguments.path)?;
        let mut command = vec!["test".to_owned(), path.into_string(), "--format=json".to_owned()];
        command.extend(arguments.filter.iter().map(|filter| format!("--filter={filter}")));
        if arguments.coverage {
            command.push("--coverage".to_owned());
        }
        let Report { document, is_complete, exit_code, messages } =
            call.report(&CommandRequest::new(command, OF_CELLS))?;
        let mut text = summary(&document);
        let failed = items(&document, "tests").iter().filter(|test| !test["failure"].is_null());
        let most = arguments.max_failures.unwrap_or(5);
        failed.clone().take(most).for_each(|test| text.push_str(&failure(call, test)));
        let others = failed.count().saturating_sub(most);
        if others > 0 {
            text.push_str(&format!("\nand {} more: raise `max_failures`\n", counted(others as u64, "failure")));
        }
        if arguments.coverage || !is_complete {
            text.push_str(&format!("{}\n", notes(&messages)));
        }
        let count = |key| number(&document, key);
        let data = json!({ "passed": count("passed"), "failed": count("failed"), "skipped": count("skipped") });
        Ok(Answer::new(exit_code == 0, text).with_data(data).with_detail(arguments.detail))
    }
}

fn summary(document: &Value) -> String {
    let mut text = format!("{} passed, {} failed", number(document, "passed"), number(document, "failed"));
    let skipped = number(document, "skipped");
    if skipped > 0 {
        text.push_str(&format!(", {skipped} skipped"));
    }
    text.push('\n');
    text
}

/// Number of prints, and of events, that a failure shows.
const LAST: usize = 10;

fn failure(call: &Call<'_>, test: &Value) -> String {
    let failure = &test["failure"];
    let mut out = format!("\n{} failed after {} s: {}\n", text(test, "id"), test["seconds"], text(failure, "message"));
    places(call, failure, &mut out);
    for other in items(failure, "others") {
        out.push_str(&format!("also: {}\n", text(other, "message")));
        places(call, other, &mut out);
    }
    last(&mut out, "prints", items(test, "prints"), |print| print.as_str().unwrap_or_default().to_owned());
    last(&mut out, "events", items(test, "events"), Value::to_string);
    let screen = items(test, "screen").iter().filter_map(Value::as_str).filter(|row| !row.trim().is_empty());
    screen.for_each(|row| out.push_str(&format!("  | {}\n", row.trim_end())));
    out
}

/// Appends the lines that led to a failure.
fn places(call: &Call<'_>, failure: &Value, out: &mut String) {
    for place in items(failure, "places") {
        let file = call.roots.shown(text(place, "file").into());
        out.push_str(&format!("  {file}:{}: {}\n", number(place, "line"), text(place, "source").trim()));
    }
}

fn last(out: &mut String, name: &str, entries: &[Value], shown: impl Fn(&Value) -> String) {
    if entries.is_empty() {
        return;
    }
    let skipped = entries.len().saturating_sub(LAST);
    out.push_str(&format!("  last {name}:\n"));
    entries.iter().skip(skipped).for_each(|entry| out.push_str(&format!("    {}\n", shown(entry))));
}
