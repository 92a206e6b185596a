//! A program without XML.

use val3_analysis::db::{Database, File, Project};
use val3_analysis::items::parse;
use val3_analysis::items::program::code;
use val3_analysis::items::project::items;
use val3_ide::{Call, incoming_calls, outgoing_calls, program_text};

use crate::projects::unknown;
use crate::refusal::Refusal;
use crate::roots::Roots;

/// Declarations, code, callers and calls of a program. Code lines have the line numbers of the file, which findings and
/// errors use as well.
pub(super) fn shown(db: &Database, roots: &Roots, project: Project, name: &str) -> Result<String, Refusal> {
    let programs = &items(db, project).programs;
    let file = *programs.get(name).ok_or_else(|| unknown("program", name, programs.keys()))?;
    let path = roots.shown(file.path(db));
    let text = program_text(db, file)
        .ok_or_else(|| Refusal(format!("the declarations of `{name}` in {path} cannot be read: `check` shows why")))?;
    let mut shown = format!("{path}\n```val3\n");
    let mut number = None;
    for line in text.lines() {
        if line.trim().eq_ignore_ascii_case("begin") {
            number = number.or(first_line(db, file));
        }
        match number.as_mut() {
            None => shown.push_str(&format!("     {line}\n")),
            Some(number) => {
                shown.push_str(&format!("{number:>4} {line}\n"));
                *number += 1;
            }
        }
    }
    shown.push_str("```\n");
    calls(&mut shown, "called by", &incoming_calls(db, file));
    calls(&mut shown, "calls", &outgoing_calls(db, file));
    Ok(shown)
}

/// Line of `begin` in the file, from 1.
fn first_line(db: &Database, file: File) -> Option<usize> {
    let parse = parse(db, file);
    let start = usize::from(code(parse.view())?.range().start());
    let text = file.text(db);
    let code = text.get(start..)?;
    let blanks = code.len() - code.trim_start().trim_start_matches("<![CDATA[").trim_start().len();
    let before = text.get(..start + blanks)?;
    Some(1 + before.matches('\n').count())
}

fn calls(text: &mut String, label: &str, calls: &[Call]) {
    if calls.is_empty() {
        return;
    }
    text.push_str(&format!("{label}: {}\n", calls.iter().map(full_name).collect::<Vec<_>>().join(", ")));
}

/// Name of the caller or called program with its project, for example `cell:start (task)`.
fn full_name(call: &Call) -> String {
    let task = if call.in_task { " (task)" } else { "" };
    format!("{}:{}{task}", call.item.project, call.item.name)
}
