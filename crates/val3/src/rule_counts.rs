//! `val3 check --statistics`: counts findings by rule.

use std::cmp::Reverse;
use std::collections::BTreeMap;
use std::io;

use codespan_reporting::term::termcolor::WriteColor;
use serde::Serialize;

use crate::format::ReportFormat;
use crate::report::{CheckReport, Finding, FindingSeverity};
use crate::user_error::UserError;

/// Finding counts for one rule.
#[derive(Debug, Serialize)]
struct RuleCount {
    code: &'static str,
    name: &'static str,
    /// Highest level of the findings.
    severity: FindingSeverity,
    count: usize,
    /// Number of findings that `--fix` fixes.
    fixable: usize,
    /// Number of findings that only `--unsafe-fixes` fixes.
    fixable_unsafely: usize,
}

/// Checks that the format supports counts. The error names the supported formats.
pub(crate) fn supports(format: ReportFormat) -> Result<(), UserError> {
    match format {
        ReportFormat::Human | ReportFormat::Concise | ReportFormat::Json | ReportFormat::JsonLines => Ok(()),
        _ => Err(UserError::new("--statistics does not support this --format")
            .with_help("use human, concise, json or json-lines")),
    }
}

/// Writes the rules with findings, sorted by decreasing number of findings.
pub(crate) fn write(format: ReportFormat, report: &CheckReport, out: &mut dyn WriteColor) -> io::Result<()> {
    let counts = counts(&report.findings);
    match format {
        ReportFormat::Json => {
            serde_json::to_writer(&mut *out, &counts)?;
            writeln!(out)
        }
        ReportFormat::JsonLines => counts.iter().try_for_each(|count| {
            serde_json::to_writer(&mut *out, count)?;
            writeln!(out)
        }),
        _ => table(&counts, out),
    }
}

fn counts(findings: &[Finding]) -> Vec<RuleCount> {
    let mut counts: BTreeMap<&str, RuleCount> = BTreeMap::new();
    for finding in findings {
        let Finding { code, name, severity, .. } = *finding;
        let none = RuleCount { code, name, severity, count: 0, fixable: 0, fixable_unsafely: 0 };
        let count = counts.entry(code).or_insert(none);
        count.count += 1;
        count.severity = count.severity.max(severity);
        match &finding.fix {
            Some(fix) if fix.safe => count.fixable += 1,
            Some(_) => count.fixable_unsafely += 1,
            None => {}
        }
    }
    let mut counts: Vec<_> = counts.into_values().collect();
    counts.sort_by_key(|row| Reverse(row.count));
    counts
}

fn table(counts: &[RuleCount], out: &mut dyn WriteColor) -> io::Result<()> {
    let width = counts.first().map_or(0, |most| most.count.to_string().len());
    for row in counts {
        let RuleCount { code, name, severity, count, .. } = row;
        writeln!(out, "{count:>width$} {} {code} {:<7} {name}", mark(row), severity.word())?;
    }
    let legend = [('*', "--fix fixes at least one"), ('?', "--fix --unsafe-fixes may fix at least one")];
    for (sign, meaning) in legend {
        if counts.iter().any(|row| mark(row) == sign) {
            writeln!(out, "{sign} {meaning}")?;
        }
    }
    Ok(())
}

fn mark(count: &RuleCount) -> char {
    match (count.fixable, count.fixable_unsafely) {
        (0, 0) => ' ',
        (0, _) => '?',
        _ => '*',
    }
}

#[cfg(test)]
mod tests {
    use clap::ValueEnum as _;
    use codespan_reporting::term::termcolor::NoColor;

    use super::*;
    use crate::report::sample;

    fn written(format: ReportFormat) -> String {
        let mut report = sample::report();
        let again = report.findings[1].clone();
        report.findings.push(again);
        let mut out = NoColor::new(Vec::new());
        write(format, &report, &mut out).unwrap();
        String::from_utf8(out.into_inner()).unwrap()
    }

    #[test]
    fn the_table_counts_findings_by_rule() {
        insta::assert_snapshot!(written(ReportFormat::Human));
    }

    #[test]
    fn the_json_has_an_object_for_each_rule() {
        insta::assert_snapshot!(written(ReportFormat::JsonLines));
    }

    #[test]
    fn the_help_lists_the_formats_that_are_supported() {
        let refused = supports(ReportFormat::Sarif).unwrap_err().to_string();
        for format in ReportFormat::value_variants() {
            let name = format.to_possible_value().unwrap();
            let is_listed = refused.split([' ', ',']).any(|word| word == name.get_name());
            assert_eq!(is_listed, supports(*format).is_ok(), "{format:?} in {refused}");
        }
    }
}
