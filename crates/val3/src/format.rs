//! Output formats of `val3 check`, one per file.

pub(crate) mod azure;
pub(crate) mod checkstyle;
pub(crate) mod concise;
pub(crate) mod github;
pub(crate) mod gitlab;
pub(crate) mod human;
pub(crate) mod json;
pub(crate) mod json_lines;
pub(crate) mod junit;
pub(crate) mod rdjson;
pub(crate) mod sarif;
pub(crate) mod val3check;

mod excerpt;
mod levels;
pub(crate) mod xml;

use std::io;

use clap::ValueEnum;
use codespan_reporting::term::termcolor::WriteColor;

use crate::output::OutputContent;
use crate::output::file_kind::OutputFileKind;
use crate::report::CheckReport;
use val3check::Template;

/// How findings are written.
#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
pub(crate) enum ReportFormat {
    /// For people: the source line with the place marked, and what to write instead
    Human,
    /// One line a finding: `path:line:column: level[CODE] message`
    Concise,
    /// One JSON document with a summary and all findings
    Json,
    /// One JSON object a line and finding
    JsonLines,
    /// Records like those of the manufacturer's checker; see --val3check-template
    #[value(name = "val3check")]
    Val3Check,
    /// SARIF 2.1.0, for code scanning services
    Sarif,
    /// Commands of GitHub Actions, shown at the lines of a pull request
    Github,
    /// The code quality report of GitLab
    Gitlab,
    /// Commands of Azure Pipelines
    Azure,
    /// JUnit XML: a suite an application, a failed test a finding
    Junit,
    /// Checkstyle XML
    Checkstyle,
    /// The JSON of reviewdog
    Rdjson,
}

impl ReportFormat {
    /// Whether the format is for people, so that a summary follows the findings.
    pub(crate) fn is_for_people(self) -> bool {
        matches!(self, Self::Human | Self::Concise)
    }

    /// Content kind of the output.
    pub(crate) fn content(self) -> OutputContent {
        match self {
            Self::Json | Self::JsonLines | Self::Sarif | Self::Gitlab | Self::Rdjson => OutputContent::Json,
            Self::Github | Self::Azure => OutputContent::Commands,
            Self::Human | Self::Concise | Self::Val3Check | Self::Junit | Self::Checkstyle => OutputContent::Words,
        }
    }
}

impl ReportFormat {
    /// File kind of a report in this format.
    pub(crate) fn file_kind(self) -> OutputFileKind {
        match self {
            Self::Json | Self::JsonLines | Self::Sarif | Self::Gitlab | Self::Rdjson => OutputFileKind::Json,
            Self::Junit | Self::Checkstyle => OutputFileKind::XmlReport,
            Self::Human | Self::Concise | Self::Val3Check | Self::Github | Self::Azure => OutputFileKind::Text,
        }
    }
}

/// Writes the findings of `report`. `template` is the record template of [`ReportFormat::Val3Check`].
pub(crate) fn write(
    format: ReportFormat,
    report: &CheckReport,
    template: &Template,
    out: &mut dyn WriteColor,
) -> io::Result<()> {
    match format {
        ReportFormat::Human => human::write(report, out),
        ReportFormat::Concise => concise::write(report, out),
        ReportFormat::Json => json::write(report, out),
        ReportFormat::JsonLines => json_lines::write(report, out),
        ReportFormat::Val3Check => val3check::write(report, template, out),
        ReportFormat::Sarif => sarif::write(report, out),
        ReportFormat::Github => github::write(report, out),
        ReportFormat::Gitlab => gitlab::write(report, out),
        ReportFormat::Azure => azure::write(report, out),
        ReportFormat::Junit => junit::write(report, out),
        ReportFormat::Checkstyle => checkstyle::write(report, out),
        ReportFormat::Rdjson => rdjson::write(report, out),
    }
}

/// Returns the output of `write` without colours.
#[cfg(test)]
fn rendered(format: ReportFormat, report: &CheckReport) -> String {
    let mut out = codespan_reporting::term::termcolor::NoColor::new(Vec::new());
    write(format, report, &Template::default(), &mut out).unwrap();
    String::from_utf8(out.into_inner()).unwrap()
}
