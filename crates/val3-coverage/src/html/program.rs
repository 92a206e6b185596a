//! Page of a program: its code with counts.

use std::fmt::Write as _;

use super::{document, escaped};
use crate::program::{Branch, LineState, ProgramCoverage};

/// Returns the page of the program in a file.
pub(super) fn page(file: &str, program: &ProgramCoverage) -> String {
    let name = format!("{}:{}", program.project, program.program);
    let (lines, branches) = (program.line_share(), program.branch_share());
    let mut body = format!(
        "<p><a href=\"index.html\">Coverage</a></p>\n<h1>{}</h1>\n<p><code>{}</code><br>lines {lines} ({}/{}), \
         branches {branches} ({}/{})</p>\n",
        escaped(&name),
        escaped(file),
        lines.hit,
        lines.total,
        branches.hit,
        branches.total
    );
    body.push_str(
        "<table class=\"code\">\n<thead><tr><th scope=\"col\">line</th><th scope=\"col\">executed</th>\
         <th scope=\"col\">code</th></tr></thead>\n<tbody>\n",
    );
    for (number, text) in &program.source {
        row(program, *number, text, &mut body);
    }
    document(&name, &(body + "</tbody>\n</table>\n"))
}

fn row(program: &ProgramCoverage, number: u32, text: &str, body: &mut String) {
    let count = program.lines.get(&number).map(u64::to_string).unwrap_or_default();
    let sides: String = program.branches_at(number).map(sides).collect();
    let _ = writeln!(
        body,
        "<tr id=\"L{number}\"{}><td class=\"number\">{number}</td><td class=\"number\">{count}</td>\
         <td><pre>{}</pre>{sides}</td></tr>",
        class(program.state(number)),
        escaped(text),
    );
}

fn class(state: LineState) -> &'static str {
    match state {
        LineState::Uncounted => "",
        LineState::Missed => " class=\"missed\"",
        LineState::Partial => " class=\"partial\"",
        LineState::Hit => " class=\"hit\"",
    }
}

/// Formats the sides of a branch with their counts, sides that were not taken first.
fn sides(branch: &Branch) -> String {
    let missing: Vec<String> = branch.missing().map(|side| escaped(&side.name)).collect();
    let taken = branch.sides.iter().filter(|side| side.hits > 0);
    let taken: Vec<String> = taken.map(|side| format!("{} {}", escaped(&side.name), side.hits)).collect();
    let missing = match missing.as_slice() {
        [] => String::new(),
        names => format!("<b>never: {}</b>", names.join("; ")),
    };
    let blank = if missing.is_empty() || taken.is_empty() { "" } else { "; " };
    format!(" <span class=\"sides\">{missing}{blank}{}</span>", taken.join("; "))
}
