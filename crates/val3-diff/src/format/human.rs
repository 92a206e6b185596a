//! Terminal format: lines of styled texts. The caller maps styles to colours.

use unicode_width::UnicodeWidthStr;

use super::escape::printable;
use crate::model::{Comparison, HunkLine, LineKind};
use crate::report::{Block, Detail, ReportItem, ReportMark, TextTable, blocks, summary};

/// Style of a text.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum TextStyle {
    /// Default text of the terminal.
    Plain,
    /// A heading.
    Heading,
    /// A name.
    Name,
    /// Less important text.
    Dim,
    /// An added item.
    Added,
    /// A removed item.
    Removed,
    /// A changed item.
    Changed,
    /// A warning.
    Warning,
}

/// A line: its texts with their styles.
pub type StyledLine = Vec<(TextStyle, String)>;

/// Formats the report, with the summary at the end.
#[must_use]
pub fn lines(comparison: &Comparison, detail: Detail) -> Vec<StyledLine> {
    let mut lines = Vec::new();
    for block in blocks(comparison, detail) {
        add(&block, &mut lines);
    }
    if !lines.is_empty() {
        lines.push(StyledLine::new());
    }
    lines.push(vec![(TextStyle::Heading, summary(comparison))]);
    lines
}

fn add(block: &Block, lines: &mut Vec<StyledLine>) {
    match block {
        Block::Heading { level: 1, text, note } => {
            if !lines.is_empty() {
                lines.push(StyledLine::new());
            }
            lines.push(heading("", text, note));
        }
        Block::Heading { text, note, .. } => lines.push(heading("  ", text, note)),
        Block::Entry(entry) => lines.push(entry_line(entry)),
        Block::Table(table) => add_table(table, lines),
        Block::Lines(groups) => add_lines(groups, lines),
    }
}

fn heading(indent: &str, text: &str, note: &str) -> StyledLine {
    let mut line = vec![(TextStyle::Heading, format!("{indent}{}", printable(text)))];
    if !note.is_empty() {
        line.push((TextStyle::Dim, format!("  {}", printable(note))));
    }
    line
}

fn entry_line(entry: &ReportItem) -> StyledLine {
    let (style, sign) = sign(entry.mark);
    let mut line = vec![(style, format!("    {sign} "))];
    if !entry.name.is_empty() {
        line.push((TextStyle::Name, printable(&entry.name)));
    }
    if !entry.text.is_empty() {
        let gap = if entry.name.is_empty() { "" } else { "  " };
        line.push((TextStyle::Plain, format!("{gap}{}", printable(&entry.text).replace('\n', " "))));
    }
    line
}

/// Returns the style and the first character of a line.
fn sign(mark: ReportMark) -> (TextStyle, &'static str) {
    match mark {
        ReportMark::Added => (TextStyle::Added, "+"),
        ReportMark::Removed => (TextStyle::Removed, "-"),
        ReportMark::Changed => (TextStyle::Changed, "~"),
        ReportMark::Note => (TextStyle::Dim, "   "),
        ReportMark::Warning => (TextStyle::Warning, "!"),
    }
}

/// Returns the width of the widest cell or title.
fn column_width(table: &TextTable, column: usize) -> usize {
    let cells = table.rows.iter().filter_map(|row| row.cells.get(column)).map(|cell| printable(cell).width());
    cells.chain(table.titles.get(column).map(|title| title.width())).max().unwrap_or(0)
}

fn add_table(table: &TextTable, lines: &mut Vec<StyledLine>) {
    let last = table.titles.len().saturating_sub(1);
    let widths: Vec<usize> = (0..table.titles.len()).map(|column| column_width(table, column)).collect();
    let titles = table.titles.iter().map(|title| (*title).to_owned()).collect::<Vec<_>>();
    for (mark, cells) in
        std::iter::once((None, &titles)).chain(table.rows.iter().map(|row| (Some(row.mark), &row.cells)))
    {
        let (style, sign) = mark.map_or((TextStyle::Dim, " "), sign);
        let mut line = vec![(style, format!("    {sign} "))];
        for (column, (cell, width)) in cells.iter().zip(&widths).enumerate() {
            let cell = printable(cell);
            let blanks = " ".repeat(width.saturating_sub(cell.width()));
            let style = if mark.is_none() {
                TextStyle::Dim
            } else if column == 0 {
                TextStyle::Name
            } else {
                TextStyle::Plain
            };
            line.push((
                style,
                match column {
                    0 => format!("{cell}{blanks}"),
                    _ if column == last => format!("  {cell}"),
                    _ => format!("  {blanks}{cell}"),
                },
            ));
        }
        lines.push(line);
    }
}

fn add_lines(groups: &[Vec<HunkLine>], lines: &mut Vec<StyledLine>) {
    let greatest = groups.iter().flatten().map(|line| line.number).max().unwrap_or(0);
    let width = greatest.to_string().len();
    for (index, group) in groups.iter().enumerate() {
        if index > 0 {
            lines.push(vec![(TextStyle::Dim, format!("      {}", "·".repeat(width)))]);
        }
        lines.extend(group.iter().map(|line| code_line(line, width)));
    }
}

fn code_line(line: &HunkLine, width: usize) -> StyledLine {
    let (style, sign) = match line.kind {
        LineKind::Context => (TextStyle::Plain, " "),
        LineKind::Removed => (TextStyle::Removed, "-"),
        LineKind::Added => (TextStyle::Added, "+"),
    };
    let text = printable(&line.text);
    vec![
        (TextStyle::Dim, format!("      {:>width$} ", line.number)),
        (style, format!("{sign} {text}").trim_end().to_owned()),
    ]
}
