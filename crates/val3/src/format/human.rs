//! Human-readable report: source lines with the marked range, related locations, and help. Errors come first, and equal
//! findings of a file are shown once.

use std::cmp::Reverse;
use std::collections::{BTreeMap, BTreeSet};
use std::io::{self, Write};
use std::sync::Arc;

use codespan_reporting::diagnostic::{Diagnostic, Label, LabelStyle, Severity as Level};
use codespan_reporting::files::Error;
use codespan_reporting::term::termcolor::WriteColor;
use codespan_reporting::term::{Config, emit_to_write_style};

use val3_files::FileClass;
use val3_syntax::encoding::{Encoding, decode};

use super::excerpt::{Excerpt, FileId};
use super::levels::Levels;
use crate::printable::one_line;
use crate::report::{CheckReport, Finding, FindingSeverity, Related, ReportRange, SourceFile};

/// Writes every finding with its source lines.
pub(crate) fn write(report: &CheckReport, out: &mut dyn WriteColor) -> io::Result<()> {
    let config = Config::default();
    Levels::before(out, |out| groups(&report.findings).iter().try_for_each(|group| write_group(group, &config, out)))
}

/// Equal findings of a file; never empty.
type FindingGroup<'a> = Vec<&'a Finding>;

/// Groups the findings: errors first, then sorted by file and range.
fn groups(findings: &[Finding]) -> Vec<FindingGroup<'_>> {
    let mut sorted: Vec<&Finding> = findings.iter().collect();
    sorted.sort_by_key(|finding| Reverse(finding.severity));
    let mut groups: Vec<FindingGroup<'_>> = Vec::new();
    let mut known: BTreeMap<_, usize> = BTreeMap::new();
    for finding in sorted {
        let Finding { severity, code, message, is_new, place, .. } = finding;
        let place = *known.entry((&place.file.path, *severity, *code, message, *is_new)).or_insert(groups.len());
        match groups.get_mut(place) {
            Some(group) => group.push(finding),
            None => groups.push(vec![finding]),
        }
    }
    groups
}

/// Lists the lines of all findings after the first one.
fn elsewhere_in_file(others: &[&Finding]) -> Option<String> {
    let lines: BTreeSet<usize> = others.iter().map(|finding| finding.place.start().line).collect();
    let words: Vec<String> = lines.iter().map(usize::to_string).collect();
    let (last, before) = words.split_last()?;
    Some(match before {
        [] => format!("the same in line {last}"),
        before => format!("the same in lines {} and {last}", before.join(", ")),
    })
}

/// A run-time error, or a reason why a program cannot run, for [`write_program_error`].
#[derive(Debug)]
pub(crate) struct ProgramError<'a> {
    /// Error number; `None` if it is no run-time error.
    pub(crate) code: Option<u16>,
    /// Problem.
    pub(crate) message: String,
    /// Remedy.
    pub(crate) help: &'a str,
    /// Label of the line.
    pub(crate) label: &'a str,
    /// Program file; empty if unknown.
    pub(crate) path: &'a str,
    /// Line of the file, from 1.
    pub(crate) line: u32,
}

/// Writes an error with its source line.
pub(crate) fn write_program_error(fault: &ProgramError<'_>, out: &mut dyn WriteColor) -> io::Result<()> {
    let text =
        val3_files::read(fault.path.into(), FileClass::Program).map(|bytes| decode(bytes).text).unwrap_or_default();
    let file = Arc::new(SourceFile::new(&one_line(fault.path), text.into(), Encoding::Utf8));
    let line = usize::try_from(fault.line).unwrap_or(usize::MAX).saturating_sub(1);
    let range = file.lines.line_range(line).unwrap_or(0..0);
    let shown = file.text.get(range.clone()).unwrap_or_default();
    let start = range.start + shown.len() - shown.trim_start().len();
    let place = ReportRange { range: start..start + shown.trim().len(), file: Arc::clone(&file) };
    let mut excerpt = Excerpt::default();
    let mut diagnostic = Diagnostic::error().with_message(one_line(&fault.message));
    diagnostic.code = fault.code.map(|code| code.to_string());
    if let Some(label) = label(&mut excerpt, LabelStyle::Primary, &place, &one_line(fault.label)) {
        diagnostic = diagnostic.with_label(label);
    }
    if !fault.help.is_empty() {
        diagnostic = diagnostic.with_note(format!("help: {}", one_line(fault.help)));
    }
    Levels::before(out, |out| match emit_to_write_style(out, &Config::default(), &excerpt, &diagnostic) {
        Err(Error::Io(error)) => Err(error),
        _ => Ok(()),
    })
}

fn write_group(group: &[&Finding], config: &Config, out: &mut Levels<'_>) -> io::Result<()> {
    let Some((finding, others)) = group.split_first() else { return Ok(()) };
    let mut excerpt = Excerpt::default();
    let mut diagnostic = diagnostic(finding, &mut excerpt);
    diagnostic.notes.extend(elsewhere_in_file(others));
    match emit_to_write_style(out, config, &excerpt, &diagnostic) {
        Ok(()) => Ok(()),
        Err(Error::Io(error)) => Err(error),
        Err(other) => writeln!(out, "{}: {other}", finding.message),
    }
}

fn diagnostic<'a>(finding: &'a Finding, excerpt: &mut Excerpt<'a>) -> Diagnostic<FileId<'a>> {
    let mut diagnostic =
        Diagnostic::new(level(finding.severity)).with_code(finding.code).with_message(finding.marked_message());
    if let Some(label) = label(excerpt, LabelStyle::Primary, &finding.place, &finding.label) {
        diagnostic = diagnostic.with_label(label);
    }
    for related in &finding.related {
        match label(excerpt, LabelStyle::Secondary, &related.place, &related.message) {
            Some(label) => diagnostic.labels.push(label),
            None => diagnostic.notes.push(elsewhere(related)),
        }
    }
    if !finding.help.is_empty() {
        diagnostic = diagnostic.with_note(format!("help: {}", finding.help));
    }
    diagnostic
}

fn label<'a>(
    excerpt: &mut Excerpt<'a>,
    style: LabelStyle,
    place: &'a ReportRange,
    message: &str,
) -> Option<Label<FileId<'a>>> {
    let (file, range) = excerpt.show(place)?;
    Some(Label::new(style, file, range).with_message(message))
}

fn elsewhere(related: &Related) -> String {
    let start = related.place.start();
    let path = &related.place.file.shown;
    format!("{path}:{}:{}: {}", start.line, start.column, related.message)
}

fn level(severity: FindingSeverity) -> Level {
    match severity {
        FindingSeverity::Info => Level::Note,
        FindingSeverity::Warning => Level::Warning,
        FindingSeverity::Error => Level::Error,
    }
}

#[cfg(test)]
mod tests {
    use codespan_reporting::term::termcolor::Ansi;

    use crate::format::{ReportFormat, rendered};
    use crate::report::{CheckReport, sample};

    #[test]
    fn findings_show_their_code() {
        insta::assert_snapshot!(rendered(ReportFormat::Human, &sample::report()));
    }

    #[test]
    fn the_most_serious_findings_come_first() {
        let shown = rendered(ReportFormat::Human, &sample::report());
        let levels: Vec<&str> = shown.lines().filter_map(|line| line.split_once('[')).map(|(level, _)| level).collect();
        assert_eq!(levels, ["error", "warning", "info"]);
    }

    #[test]
    fn equal_findings_of_a_file_are_shown_once() {
        let mut report = sample::report();
        repeat_finding(&mut report, "end]]>");
        assert!(rendered(ReportFormat::Human, &report).contains("the same in line 8\n"));
        repeat_finding(&mut report, "</Programs>");
        let shown = rendered(ReportFormat::Human, &report);
        assert!(shown.contains("the same in lines 8 and 10\n") && shown.matches("V0101").count() == 1, "{shown}");
        report.findings.iter_mut().for_each(|finding| finding.is_new = finding.code == "V0203");
        assert!(rendered(ReportFormat::Human, &report).contains("got a string (new)\n"));
    }

    /// Adds the finding V0101 of the sample once more, at another line.
    fn repeat_finding(report: &mut CheckReport, line: &str) {
        let mut finding = report.findings.iter().find(|finding| finding.code == "V0101").unwrap().clone();
        finding.place = sample::place(&finding.place.file, line);
        report.findings.push(finding);
    }

    #[test]
    fn colours_are_written_on_request() {
        let mut out = Ansi::new(Vec::new());
        super::write(&sample::report(), &mut out).unwrap();
        let text = String::from_utf8(out.into_inner()).unwrap();
        assert!(text.contains("\u{1b}[") && text.contains("info"), "{text}");
    }

    #[test]
    fn nothing_found_writes_nothing() {
        assert_eq!(rendered(ReportFormat::Human, &sample::clean()), "");
    }
}
