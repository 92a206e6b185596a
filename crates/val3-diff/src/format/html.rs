//! HTML format: one page without scripts or other files. It is light or dark according to the reader's system.

use std::fmt::Write as _;

use super::escape::html;
use crate::model::{Comparison, HunkLine, LineKind};
use crate::report::{Block, Detail, ReportItem, ReportMark, TextTable, blocks, summary};

const STYLE: &str = include_str!("html/style.css");

/// Writes the page.
#[must_use]
pub fn write(comparison: &Comparison, detail: Detail) -> String {
    let title = html(&format!("{} → {}", comparison.old, comparison.new));
    let mut out = format!(
        "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n\
         <meta name=\"viewport\" content=\"width=device-width\">\n<meta name=\"color-scheme\" content=\"light dark\">\n\
         <title>{title}</title>\n<style>\n{STYLE}</style>\n</head>\n<body>\n<h1>{title}</h1>\n<p>{}</p>\n",
        html(&summary(comparison))
    );
    let mut in_list = false;
    for block in blocks(comparison, detail) {
        let is_entry = matches!(block, Block::Entry(_));
        match (in_list, is_entry) {
            (false, true) => out.push_str("<ul>\n"),
            (true, false) => out.push_str("</ul>\n"),
            _ => {}
        }
        in_list = is_entry;
        add(&block, &mut out);
    }
    if in_list {
        out.push_str("</ul>\n");
    }
    out + "</body>\n</html>\n"
}

fn add(block: &Block, out: &mut String) {
    match block {
        Block::Heading { level, text, note } => {
            let note = if note.is_empty() { String::new() } else { format!(" <small>{}</small>", html(note)) };
            let level = level + 1;
            let _ = writeln!(out, "<h{level}>{}{note}</h{level}>", html(text));
        }
        Block::Entry(entry) => add_entry(entry, out),
        Block::Table(table) => add_table(table, out),
        Block::Lines(groups) => add_lines(groups, out),
    }
}

/// Returns the CSS class of a line, and a sign for readers who cannot see colours.
fn mark(mark: ReportMark) -> (&'static str, &'static str) {
    match mark {
        ReportMark::Added => ("added", "+"),
        ReportMark::Removed => ("removed", "−"),
        ReportMark::Changed => ("changed", "~"),
        ReportMark::Note => ("note", ""),
        ReportMark::Warning => ("warning", "!"),
    }
}

fn add_entry(entry: &ReportItem, out: &mut String) {
    let (class, sign) = mark(entry.mark);
    let name = if entry.name.is_empty() { String::new() } else { format!("<code>{}</code> ", html(&entry.name)) };
    let _ = writeln!(out, "<li class=\"{class}\"><b>{sign}</b> {name}{}</li>", html(&entry.text));
}

fn add_table(table: &TextTable, out: &mut String) {
    let last = table.titles.len().saturating_sub(1);
    let titles = table.titles.iter().enumerate();
    let titles: String = titles.map(|(column, title)| title_cell(title, column == 0 || column == last)).collect();
    let _ = writeln!(out, "<table>\n<tr>{titles}</tr>");
    for row in &table.rows {
        let cells = row.cells.iter().enumerate();
        let cells: String = cells.map(|(column, text)| cell(text, column, column == last)).collect();
        let _ = writeln!(out, "<tr class=\"{}\">{cells}</tr>", mark(row.mark).0);
    }
    out.push_str("</table>\n");
}

fn title_cell(title: &str, is_text: bool) -> String {
    if is_text { format!("<th>{title}</th>") } else { format!("<th class=\"number\">{title}</th>") }
}

/// Formats a cell. The first column contains names, the last one text, all others numbers.
fn cell(text: &str, column: usize, is_last: bool) -> String {
    match column {
        0 => format!("<td><code>{}</code></td>", html(text)),
        _ if is_last => format!("<td>{}</td>", html(text)),
        _ => format!("<td class=\"number\">{}</td>", html(text)),
    }
}

fn add_lines(groups: &[Vec<HunkLine>], out: &mut String) {
    out.push_str("<pre>");
    for (index, group) in groups.iter().enumerate() {
        if index > 0 {
            out.push_str("<i>⋯</i>\n");
        }
        for line in group {
            let (class, sign) = match line.kind {
                LineKind::Context => ("context", ' '),
                LineKind::Removed => ("removed", '-'),
                LineKind::Added => ("added", '+'),
            };
            let _ =
                writeln!(out, "<span class=\"{class}\"><i>{:>5}</i> {sign} {}</span>", line.number, html(&line.text));
        }
    }
    out.push_str("</pre>\n");
}
