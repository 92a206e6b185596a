//! JSON of reviewdog, which posts findings and suggested fixes to most review services.
//!
//! Columns count UTF-8 bytes, as reviewdog requires.

use std::io;

use codespan_reporting::term::termcolor::WriteColor;
use serde::Serialize;
use val3_lines::ColumnCounting;

use crate::report::{CheckReport, Finding, FindingSeverity, ReportRange, ReportedEdit};

/// Writes the document and a line end.
pub(crate) fn write(report: &CheckReport, out: &mut dyn WriteColor) -> io::Result<()> {
    let document =
        Document { source: Source { name: "val3" }, diagnostics: report.findings.iter().map(Diagnostic::of).collect() };
    serde_json::to_writer_pretty(&mut *out, &document)?;
    writeln!(out)
}

#[derive(Serialize)]
struct Document<'a> {
    source: Source,
    diagnostics: Vec<Diagnostic<'a>>,
}

#[derive(Serialize)]
struct Source {
    name: &'static str,
}

#[derive(Serialize)]
struct Diagnostic<'a> {
    message: String,
    location: Location<'a>,
    severity: &'static str,
    code: Code,
    #[serde(skip_serializing_if = "Vec::is_empty")]
    suggestions: Vec<Suggestion<'a>>,
}

#[derive(Serialize)]
struct Location<'a> {
    path: &'a str,
    range: Range,
}

#[derive(Serialize)]
struct Code {
    value: &'static str,
}

#[derive(Serialize)]
struct Suggestion<'a> {
    range: Range,
    text: &'a str,
}

#[derive(Serialize)]
struct Range {
    start: Position,
    end: Position,
}

#[derive(Serialize)]
struct Position {
    line: usize,
    column: usize,
}

impl<'a> Diagnostic<'a> {
    fn of(finding: &'a Finding) -> Self {
        // Reviewdog shows several suggestions as alternatives, so only fixes with one edit are written.
        let edits = finding.fix.iter().map(|fix| &fix.edits).filter(|edits| edits.len() == 1).flatten();
        Self {
            message: finding.message_with_help(),
            location: Location { path: &finding.place.file.in_repository, range: Range::of(&finding.place) },
            severity: severity(finding.severity),
            code: Code { value: finding.code },
            suggestions: edits.map(Suggestion::of).collect(),
        }
    }
}

impl<'a> Suggestion<'a> {
    fn of(edit: &'a ReportedEdit) -> Self {
        Self { range: Range::of(&edit.place), text: &edit.text }
    }
}

impl Range {
    fn of(place: &ReportRange) -> Self {
        let at = |offset| Position::of(place, offset);
        Self { start: at(place.range.start), end: at(place.range.end) }
    }
}

impl Position {
    fn of(place: &ReportRange, offset: usize) -> Self {
        let at = place.file.lines.line_column(offset, ColumnCounting::BYTES);
        Self { line: at.line as usize + 1, column: at.column as usize + 1 }
    }
}

fn severity(severity: FindingSeverity) -> &'static str {
    match severity {
        FindingSeverity::Info => "INFO",
        FindingSeverity::Warning => "WARNING",
        FindingSeverity::Error => "ERROR",
    }
}

#[cfg(test)]
mod tests {
    use crate::format::{ReportFormat, rendered};
    use crate::report::sample;

    #[test]
    fn the_document_lists_findings() {
        insta::assert_snapshot!(rendered(ReportFormat::Rdjson, &sample::report()));
    }
}
