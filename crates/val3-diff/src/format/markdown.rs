//! Markdown format for merge requests and wikis.

use std::fmt::Write as _;

use super::escape::{code_span, markdown, printable};
use crate::model::{Comparison, HunkLine, LineKind};
use crate::report::{Block, Detail, ReportItem, ReportMark, TextTable, blocks, summary};

/// Writes the report.
#[must_use]
pub fn write(comparison: &Comparison, detail: Detail) -> String {
    let mut out =
        format!("# {} → {}\n\n{}\n", code_span(&comparison.old), code_span(&comparison.new), summary(comparison));
    let mut in_list = false;
    for block in blocks(comparison, detail) {
        let is_entry = matches!(block, Block::Entry(_));
        if !(is_entry && in_list) {
            out.push('\n');
        }
        in_list = is_entry;
        add(&block, &mut out);
    }
    out
}

fn add(block: &Block, out: &mut String) {
    match block {
        Block::Heading { level, text, note } => {
            let signs = "#".repeat(usize::from(*level) + 1);
            let note = if note.is_empty() { String::new() } else { format!(" ({})", markdown(note)) };
            let _ = writeln!(out, "{signs} {}{note}", markdown(text));
        }
        Block::Entry(entry) => add_entry(entry, out),
        Block::Table(table) => add_table(table, out),
        Block::Lines(groups) => add_lines(groups, out),
    }
}

fn add_entry(entry: &ReportItem, out: &mut String) {
    let word = match entry.mark {
        ReportMark::Added => "- **added** ",
        ReportMark::Removed => "- **removed** ",
        ReportMark::Changed => "- **changed** ",
        ReportMark::Warning => "- **note** ",
        ReportMark::Note => "  - ",
    };
    let name = if entry.name.is_empty() { String::new() } else { code_span(&entry.name) };
    let gap = if entry.name.is_empty() || entry.text.is_empty() { "" } else { " " };
    let _ = writeln!(out, "{word}{name}{gap}{}", markdown(&entry.text));
}

fn add_table(table: &TextTable, out: &mut String) {
    let _ = writeln!(out, "| {} |", table.titles.join(" | "));
    let last = table.titles.len().saturating_sub(1);
    let rule = |column: usize| if column == 0 || column == last { "---" } else { "--:" };
    let _ = writeln!(out, "|{}|", (0..table.titles.len()).map(rule).collect::<Vec<_>>().join("|"));
    for row in &table.rows {
        let cell = |(column, text): (usize, &String)| if column == 0 { code_span(text) } else { markdown(text) };
        let _ = writeln!(out, "| {} |", row.cells.iter().enumerate().map(cell).collect::<Vec<_>>().join(" | "));
    }
}

fn add_lines(groups: &[Vec<HunkLine>], out: &mut String) {
    let texts = groups.iter().flatten().map(|line| line.text.as_str());
    let longest = texts.flat_map(|text| text.split(|character| character != '`')).map(str::len).max().unwrap_or(0);
    let fence = "`".repeat(longest.max(2) + 1);
    let _ = writeln!(out, "{fence}diff");
    for group in groups {
        let first = group.first().map_or(1, |line| line.number);
        let _ = writeln!(out, "@@ line {first} @@");
        for line in group {
            let sign = match line.kind {
                LineKind::Context => ' ',
                LineKind::Removed => '-',
                LineKind::Added => '+',
            };
            let _ = writeln!(out, "{sign}{}", printable(&line.text));
        }
    }
    let _ = writeln!(out, "{fence}");
}
