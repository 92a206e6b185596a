//! One JSON document with a stable schema: while `version` is 1, fields are added but never renamed or removed.
//!
//! ```json
//! {"version": 1,
//!  "summary": {"applications": 1, "files": 3, "programs": 1, "code_lines": 12,
//!              "errors": 1, "warnings": 0, "infos": 0, "omitted": {}},
//!  "diagnostics": [{
//!    "code": "V0203", "name": "argument-type", "severity": "error",
//!    "message": "…", "label": "…", "help": "…", "file": "pal/pick.pgx",
//!    "range": {"start": {"line": 6, "column": 21, "offset": 200}, "end": {"line": 6, "column": 27, "offset": 206}},
//!    "program": "pick", "code_line": 3, "application": "pal/pal.pjx",
//!    "related": [{"file": "pal/pal.dtx", "range": {}, "message": "…"}],
//!    "fixable": true,
//!    "fix": {"title": "…", "safe": true, "edits": [{"file": "pal/pick.pgx", "range": {}, "text": "…"}]}}]}
//! ```
//! - The document contains no time, so that equal files have equal reports.
//! - `omitted` counts the findings beyond `--max-findings`, by code.
//! - `severity` is `error`, `warning` or `info`.
//! - `label` describes the range, and `help` the remedy. Either is empty if it would add nothing.
//! - `file` and `application` are relative to the requested folder, with `/`. For a file without a project,
//!   `application` is the file itself, and for an archive that is not read, it is `null`.
//! - `line` and `column` count from 1, columns in characters; `offset` counts the bytes of the stored file from 0.
//!   `end` is the first position after the range.
//! - `program` is `null` outside of programs; `code_line`, which counts the line of `begin` as 1, is `null` outside of
//!   their code.
//! - `fix` is `null` without a fix. A `safe` fix keeps the behaviour of the program or is certainly intended. `text`
//!   replaces the range and is encoded like the file: escaped if the code is escaped.
//! - `code_lines` omits blank lines and comments.

use std::collections::BTreeMap;
use std::io;

use codespan_reporting::term::termcolor::WriteColor;
use serde::Serialize;

use crate::report::{
    CheckReport, Finding, FindingSeverity, Related, ReportPosition, ReportRange, ReportStatistics, ReportedEdit,
    ReportedFix,
};

/// Writes the document and a line end.
pub(crate) fn write(report: &CheckReport, out: &mut dyn WriteColor) -> io::Result<()> {
    let document = Document {
        version: 1,
        summary: Summary::of(report),
        diagnostics: report.findings.iter().map(JsonDiagnostic::of).collect(),
    };
    serde_json::to_writer(&mut *out, &document)?;
    writeln!(out)
}

#[derive(Serialize)]
struct Document<'a> {
    version: u32,
    summary: Summary,
    diagnostics: Vec<JsonDiagnostic<'a>>,
}

#[derive(Serialize)]
struct Summary {
    applications: usize,
    files: usize,
    programs: usize,
    code_lines: usize,
    errors: usize,
    warnings: usize,
    infos: usize,
    omitted: BTreeMap<&'static str, usize>,
}

impl Summary {
    fn of(report: &CheckReport) -> Self {
        let ReportStatistics { applications, files, programs, code_lines, .. } = report.statistics;
        Self {
            applications,
            files,
            programs,
            code_lines,
            errors: report.count(FindingSeverity::Error),
            warnings: report.count(FindingSeverity::Warning),
            infos: report.count(FindingSeverity::Info),
            omitted: report.omitted().into_iter().collect(),
        }
    }
}

/// A finding in the formats `json` and `json-lines`.
#[derive(Serialize)]
pub(super) struct JsonDiagnostic<'a> {
    code: &'a str,
    name: &'a str,
    severity: FindingSeverity,
    message: &'a str,
    label: &'a str,
    help: &'a str,
    #[serde(flatten)]
    place: JsonPlace<'a>,
    program: Option<&'a str>,
    code_line: Option<usize>,
    application: Option<&'a str>,
    related: Vec<JsonRelated<'a>>,
    fixable: bool,
    fix: Option<JsonFix<'a>>,
}

impl<'a> JsonDiagnostic<'a> {
    pub(super) fn of(finding: &'a Finding) -> Self {
        Self {
            code: finding.code,
            name: finding.name,
            severity: finding.severity,
            message: &finding.message,
            label: &finding.label,
            help: &finding.help,
            place: JsonPlace::of(&finding.place),
            program: finding.program.as_deref(),
            code_line: finding.code_line,
            application: finding.application.as_deref(),
            related: finding.related.iter().map(JsonRelated::of).collect(),
            fixable: finding.fix.is_some(),
            fix: finding.fix.as_ref().map(JsonFix::of),
        }
    }
}

#[derive(Serialize)]
struct JsonRelated<'a> {
    #[serde(flatten)]
    place: JsonPlace<'a>,
    message: &'a str,
}

impl<'a> JsonRelated<'a> {
    fn of(related: &'a Related) -> Self {
        Self { place: JsonPlace::of(&related.place), message: &related.message }
    }
}

#[derive(Serialize)]
struct JsonFix<'a> {
    title: &'a str,
    safe: bool,
    edits: Vec<JsonEdit<'a>>,
}

impl<'a> JsonFix<'a> {
    fn of(fix: &'a ReportedFix) -> Self {
        Self { title: &fix.title, safe: fix.safe, edits: fix.edits.iter().map(JsonEdit::of).collect() }
    }
}

#[derive(Serialize)]
struct JsonEdit<'a> {
    #[serde(flatten)]
    place: JsonPlace<'a>,
    text: &'a str,
}

impl<'a> JsonEdit<'a> {
    fn of(edit: &'a ReportedEdit) -> Self {
        Self { place: JsonPlace::of(&edit.place), text: &edit.text }
    }
}

#[derive(Serialize)]
struct JsonPlace<'a> {
    file: &'a str,
    range: JsonRange,
}

#[derive(Serialize)]
struct JsonRange {
    start: JsonPosition,
    end: JsonPosition,
}

#[derive(Serialize)]
struct JsonPosition {
    line: usize,
    column: usize,
    offset: usize,
}

impl<'a> JsonPlace<'a> {
    fn of(place: &'a ReportRange) -> Self {
        Self {
            file: &place.file.path,
            range: JsonRange { start: JsonPosition::of(place.start()), end: JsonPosition::of(place.end()) },
        }
    }
}

impl JsonPosition {
    fn of(position: ReportPosition) -> Self {
        let ReportPosition { line, column, offset } = position;
        Self { line, column, offset }
    }
}

#[cfg(test)]
mod tests {
    use crate::format::{ReportFormat, rendered};
    use crate::report::sample;

    #[test]
    fn the_document_lists_findings() {
        let document = rendered(ReportFormat::Json, &sample::report());
        let value: serde_json::Value = serde_json::from_str(&document).unwrap();
        insta::assert_snapshot!(serde_json::to_string_pretty(&value).unwrap());
    }

    #[test]
    fn fields_have_a_fixed_order() {
        insta::assert_snapshot!(rendered(ReportFormat::Json, &sample::clean()), @r#"{"version":1,"summary":{"applications":1,"files":3,"programs":1,"code_lines":1412,"errors":0,"warnings":0,"infos":0,"omitted":{}},"diagnostics":[]}"#);
    }
}
