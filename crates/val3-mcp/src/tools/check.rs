//! `check`: findings of applications.

mod finding;

use schemars::JsonSchema;
use serde::Deserialize;
use serde_json::{Value, json};

use crate::answer::Answer;
use crate::command::{CommandRequest, OF_CELLS, Report};
use crate::refusal::Refusal;
use crate::report::{counted, items, notes, number};
use crate::tool::{Call, Definition};

/// The tool.
pub(super) struct Check;

/// Arguments.
#[derive(Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub(super) struct Arguments {
    /// Cell, application, library, or a single .pgx or .dtx
    #[serde(default = "crate::arguments::here")]
    path: String,
    /// Also reach, limits and singularities of points and moves
    #[serde(default)]
    motion: bool,
    /// Findings that are described, the most serious first; the others are counted. Default: 20
    max: Option<usize>,
    /// Up to 24 kB instead of 8 kB
    #[serde(default)]
    detail: bool,
}

impl Definition for Check {
    const NAME: &'static str = "check";
    const TITLE: &'static str = "Check applications";
    const DESCRIPTION: &'static str = "Finds mistakes in VAL 3 projects: what the controller rejects (errors), and what \
        certainly or probably fails (warnings, infos). Returns for each finding its line, the reason, the remedy, and a \
        fix as a diff. Executes nothing.";
    type Arguments = Arguments;

    fn call(call: &Call<'_>, arguments: Arguments) -> Result<Answer, Refusal> {
        let path = call.roots.resolve(&arguments.path)?;
        let most = arguments.max.unwrap_or(20);
        let mut command = vec!["check".to_owned(), path.to_string(), "--format=json".to_owned()];
        command.push(format!("--max-findings={most}"));
        if arguments.motion {
            command.push("--motion".to_owned());
        }
        let Report { document, is_complete, messages, .. } = call.report(&CommandRequest::new(command, OF_CELLS))?;
        let summary = document.get("summary").unwrap_or(&Value::Null);
        let mut text = headline(summary);
        let folder = if path.is_file() { path.parent().unwrap_or(&path) } else { &path };
        for finding in items(&document, "diagnostics") {
            text.push_str(&finding::shown(call.roots, folder, finding));
        }
        text.push_str(&omitted(summary));
        if !is_complete {
            text.push_str(&format!("{}\n", notes(&messages)));
        }
        let count = |key| number(summary, key);
        let data = json!({ "errors": count("errors"), "warnings": count("warnings"), "infos": count("infos") });
        Ok(Answer::new(is_complete && count("errors") == 0, text).with_data(data).with_detail(arguments.detail))
    }
}

fn headline(summary: &Value) -> String {
    let counts = [("errors", "error"), ("warnings", "warning"), ("infos", "info")];
    let counts = counts.map(|(key, noun)| counted(number(summary, key), noun)).join(", ");
    let (applications, programs) = (number(summary, "applications"), number(summary, "programs"));
    format!("{counts} in {}, {}\n", counted(applications, "project"), counted(programs, "program"))
}

/// Findings beyond the requested number, counted by code.
fn omitted(summary: &Value) -> String {
    let omitted = summary.get("omitted").and_then(Value::as_object).into_iter().flatten();
    let omitted: Vec<(&String, u64)> =
        omitted.map(|(code, count)| (code, count.as_u64().unwrap_or_default())).collect();
    let sum: u64 = omitted.iter().map(|(_, count)| count).sum();
    if sum == 0 {
        return String::new();
    }
    let codes: Vec<String> = omitted.iter().map(|(code, count)| format!("{code} × {count}")).collect();
    format!("\nand {sum} more ({}): raise `max`, or check one project\n", codes.join(", "))
}
