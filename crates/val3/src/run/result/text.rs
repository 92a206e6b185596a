//! The result as lines for people and language models.

use std::fmt::Write as _;

use super::document::{ErrorEntry, IoEntry, LineMoves, ProgramMoves, ResultDocument, TaskEntry, WaitEntry};
use super::listed::Listed;
use crate::printable::one_line;

/// Maximum number of waits.
const SHOWN_WAITS: usize = 8;

/// Formats the document. Empty parts are omitted.
pub(super) fn text(document: &ResultDocument) -> String {
    let mut out = String::new();
    let ResultDocument { reason, seconds, exit_code, .. } = document;
    line(&mut out, &format!("{reason} after {seconds:.3} s of the controller's clock; exit code {exit_code}"));
    document.tasks.iter().for_each(|entry| line(&mut out, &format!("task {}", task(entry))));
    list(&mut out, "errors", &document.errors, error);
    document.contacts.iter().for_each(|contact| line(&mut out, &format!("contact: {contact}")));
    document.near_misses.iter().for_each(|near| line(&mut out, &format!("near: {near}")));
    list(&mut out, "notes", &document.notes, String::clone);
    list(&mut out, "prints", &document.prints, String::clone);
    list(&mut out, "event log", &document.log, String::clone);
    if !document.screen.is_empty() {
        line(&mut out, "screen at the end:");
        document.screen.iter().for_each(|row| line(&mut out, &format!("  | {row}")));
    }
    moves(&mut out, document);
    if !document.waits.is_empty() {
        line(&mut out, "waits, longest first:");
        document.waits.iter().take(SHOWN_WAITS).for_each(|entry| line(&mut out, &format!("  {}", wait(entry))));
    }
    list(&mut out, "io changes", &document.io, io);
    document.next.iter().for_each(|next| line(&mut out, &format!("next: {next}")));
    out
}

fn line(out: &mut String, text: &str) {
    // Writing to a string does not fail.
    let _ = writeln!(out, "{}", one_line(text));
}

fn list<T>(out: &mut String, name: &str, listed: &Listed<T>, format: impl Fn(&T) -> String) {
    match (listed.count, listed.last.len()) {
        (0, _) => return,
        (count, shown) if shown < count => line(out, &format!("{name}: {count}, the last {shown}")),
        (count, _) => line(out, &format!("{name}: {count}")),
    }
    listed.last.iter().for_each(|item| line(out, &format!("  {}", format(item))));
}

fn joined<T>(items: &[T], format: impl Fn(&T) -> String) -> String {
    items.iter().map(format).collect::<Vec<_>>().join(", ")
}

fn task(entry: &TaskEntry) -> String {
    let code = entry.at.code.as_ref().map(|code| format!(": {code}")).unwrap_or_default();
    format!("`{}` {} at {}{code}", entry.name, entry.activity, entry.at.place())
}

fn error(entry: &ErrorEntry) -> String {
    let ErrorEntry { t, code, message, task, at, handled, .. } = entry;
    let number = code.map(|code| format!("{code} ")).unwrap_or_default();
    let of_task = if task.is_empty() { String::new() } else { format!(" in task `{task}`") };
    let end = if *handled { "handled" } else { "not handled" };
    let code = at.code.as_ref().map(|code| format!(": {code}")).unwrap_or_default();
    format!("{number}{message} at {}{of_task} at {t:.3} s, {end}{code}", at.place())
}

fn moves(out: &mut String, document: &ResultDocument) {
    let moves = &document.moves;
    if moves.count == 0 {
        return;
    }
    let slowest = moves.lines.first().map(|LineMoves { program, line, instruction, seconds, .. }| {
        format!("; slowest line {program}:{line} `{instruction}` {seconds:.2} s")
    });
    let programs = joined(&moves.programs, program_moves);
    let (count, seconds) = (moves.count, moves.seconds);
    line(out, &format!("moves: {count} in {seconds:.2} s: {programs}{}", slowest.unwrap_or_default()));
}

fn program_moves(ProgramMoves { program, count, seconds }: &ProgramMoves) -> String {
    format!("{program} {count} ({seconds:.2} s)")
}

fn wait(WaitEntry { task, program, line, what, seconds }: &WaitEntry) -> String {
    format!("{seconds:.2} s task `{task}` for {what} at {program}:{line}")
}

fn io(IoEntry { t, link, value }: &IoEntry) -> String {
    format!("{t:.3} s {link} = {value}")
}
