//! Pages about run-time errors and library instruction results.

use val3_lang::instructions;
use val3_lang::library_errors::{LIBRARY_ERRORS, LibraryError};
use val3_lang::runtime_errors::{RUNTIME_ERRORS, RuntimeError};

use super::topic::{Topic, TopicKind};

/// Pages of all numbers.
pub(super) fn topics() -> Vec<Topic> {
    RUNTIME_ERRORS.iter().map(runtime_error).chain(LIBRARY_ERRORS.iter().map(library_error)).collect()
}

fn runtime_error(row: &RuntimeError) -> Topic {
    let page = format!("# {} {} (run-time error)\n\n{}\n{}", row.number, row.short, row.long, raised_by(row.number));
    topic(TopicKind::RuntimeError, row.number, row.short, page)
}

/// Paragraph with the instructions that can raise a run-time error.
fn raised_by(number: u16) -> String {
    let raising = instructions::all().iter().filter(|row| row.errors.contains(&number));
    let names: Vec<_> = raising.map(|row| format!("`{}`", row.name)).collect();
    if names.is_empty() { String::new() } else { format!("\nInstructions that raise it: {}.\n", names.join(", ")) }
}

fn library_error(row: &LibraryError) -> Topic {
    let page = format!("# {} {} (result of a library instruction)\n\n{}\n", row.number, row.short, row.long);
    topic(TopicKind::LibraryError, row.number, row.short, page)
}

fn topic(kind: TopicKind, number: u16, short: &str, page: String) -> Topic {
    Topic {
        kind,
        group: "",
        names: vec![number.to_string()],
        stem: number.to_string(),
        title: format!("{number} {short}"),
        summary: short.to_owned(),
        page,
    }
}
