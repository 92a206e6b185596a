//! For people: the source line with the place marked, the other sides, and what to write instead.

use std::io::{self, Write};
use std::sync::Arc;

use codespan_reporting::diagnostic::{Diagnostic, Label, LabelStyle, Severity as Level};
use codespan_reporting::files::Error;
use codespan_reporting::term::termcolor::WriteColor;
use codespan_reporting::term::{Config, emit_to_write_style};

use val3_syntax::encoding::{Encoding, decode};

use super::excerpt::{Excerpt, FileId};
use super::printable::Printable;
use crate::report::{Finding, Place, Related, Report, Severity, SourceFile};

/// Writes every finding with its source lines.
pub(crate) fn write(report: &Report, out: &mut dyn WriteColor) -> io::Result<()> {
    let config = Config::default();
    Printable::before(out, |out| report.findings.iter().try_for_each(|finding| write_finding(finding, &config, out)))
}

/// A run-time error or what keeps a program from running, for [`write_fault`].
#[derive(Debug)]
pub(crate) struct Fault<'a> {
    /// Its number; `None` for what no run-time error is.
    pub(crate) code: Option<u16>,
    /// What has happened.
    pub(crate) message: String,
    /// What to do about it.
    pub(crate) help: &'a str,
    /// What its line is.
    pub(crate) label: &'a str,
    /// The file of the program; empty where it is not known.
    pub(crate) path: &'a str,
    /// The line of the file, from 1.
    pub(crate) line: u32,
}

/// Writes a fault with its line.
pub(crate) fn write_fault(fault: &Fault<'_>, out: &mut dyn WriteColor) -> io::Result<()> {
    let text = std::fs::read(fault.path).map(|bytes| decode(bytes).text).unwrap_or_default();
    let file = Arc::new(SourceFile::new(fault.path, text.into(), Encoding::Utf8));
    let line = usize::try_from(fault.line).unwrap_or(usize::MAX).saturating_sub(1);
    let range = file.lines.line_range(line).unwrap_or(0..0);
    let shown = file.text.get(range.clone()).unwrap_or_default();
    let start = range.start + shown.len() - shown.trim_start().len();
    let place = Place { range: start..start + shown.trim().len(), file: Arc::clone(&file) };
    let mut excerpt = Excerpt::default();
    let mut diagnostic = Diagnostic::error().with_message(&fault.message);
    diagnostic.code = fault.code.map(|code| code.to_string());
    if let Some(label) = label(&mut excerpt, LabelStyle::Primary, &place, fault.label) {
        diagnostic = diagnostic.with_label(label);
    }
    if !fault.help.is_empty() {
        diagnostic = diagnostic.with_note(format!("help: {}", fault.help));
    }
    Printable::before(out, |out| match emit_to_write_style(out, &Config::default(), &excerpt, &diagnostic) {
        Err(Error::Io(error)) => Err(error),
        _ => Ok(()),
    })
}

fn write_finding(finding: &Finding, config: &Config, out: &mut Printable<'_>) -> io::Result<()> {
    let mut excerpt = Excerpt::default();
    let diagnostic = diagnostic(finding, &mut excerpt);
    match emit_to_write_style(out, config, &excerpt, &diagnostic) {
        Ok(()) => Ok(()),
        Err(Error::Io(error)) => Err(error),
        Err(other) => writeln!(out, "{}: {other}", finding.message),
    }
}

fn diagnostic<'a>(finding: &'a Finding, excerpt: &mut Excerpt<'a>) -> Diagnostic<FileId<'a>> {
    let mut diagnostic =
        Diagnostic::new(level(finding.severity)).with_code(finding.code).with_message(&finding.message);
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
    place: &'a Place,
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

fn level(severity: Severity) -> Level {
    match severity {
        Severity::Info => Level::Note,
        Severity::Warning => Level::Warning,
        Severity::Error => Level::Error,
    }
}

#[cfg(test)]
mod tests {
    use codespan_reporting::term::termcolor::Ansi;

    use crate::format::{Format, rendered};
    use crate::report::sample;

    #[test]
    fn findings_show_their_lines() {
        insta::assert_snapshot!(rendered(Format::Human, &sample::report()));
    }

    #[test]
    fn colours_are_there_when_wanted() {
        let mut out = Ansi::new(Vec::new());
        super::write(&sample::report(), &mut out).unwrap();
        let text = String::from_utf8(out.into_inner()).unwrap();
        assert!(text.contains("\u{1b}[") && text.contains("info"), "{text}");
    }

    #[test]
    fn nothing_found_writes_nothing() {
        assert_eq!(rendered(Format::Human, &sample::clean()), "");
    }
}
