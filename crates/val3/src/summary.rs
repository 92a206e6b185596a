//! Final lines of a human-readable report: counts of findings and files.

use std::io::{self, Write};

use crate::baseline::BaselineResult;
use crate::report::{CheckReport, FindingSeverity, ReportChanges};

/// Maximum number of rules whose omitted findings are counted separately.
const LISTED_RULES: usize = 8;

/// Writes the counts and, if there are findings, a reference to the pages.
pub(crate) fn write(report: &CheckReport, out: &mut dyn Write) -> io::Result<()> {
    if let Some(finding) = most_serious(report) {
        writeln!(out, "More about a finding: val3 explain {}", finding)?;
    }
    writeln!(out, "{}", counts(report))?;
    if let Some(ReportChanges { new, gone }) = report.changes {
        writeln!(out, "since the last check: {} new, {} removed", grouped(new), grouped(gone))?;
    }
    left_out(report, out)?;
    fixes(report).map_or(Ok(()), |fixes| writeln!(out, "{fixes}"))
}

/// Note on the check before a run, which only shows errors.
pub(crate) fn of_checked_run(report: &CheckReport) -> String {
    let found = format!("the check has {} {}", findings(report), files(report));
    if report.all().next().is_none() { found } else { format!("{found}; `val3 check` shows them") }
}

/// Writes the number of unreported findings, and the effect of the baselines.
fn left_out(report: &CheckReport, out: &mut dyn Write) -> io::Result<()> {
    let BaselineResult { known, gone, written } = &report.baseline;
    let hidden = [(*known, "known from the baseline"), (report.silenced, "silenced by comments")];
    let hidden = hidden.iter().filter(|(count, _)| *count > 0).map(|(count, why)| format!("{} {why}", grouped(*count)));
    let hidden: Vec<_> = limited(report).into_iter().chain(hidden).collect();
    if !hidden.is_empty() {
        writeln!(out, "not shown: {}", hidden.join(", "))?;
    }
    if *gone > 0 {
        let findings = number(*gone, "known finding");
        writeln!(out, "no longer found: {findings}; --prune-baseline removes them from the baseline")?;
    }
    written.iter().try_for_each(|(path, count)| writeln!(out, "wrote {path} with {}", number(*count, "known finding")))
}

/// Describes the findings that `--max-findings` omits: `31 findings (V0602: 28, V0109: 3) beyond --max-findings`.
pub(crate) fn limited(report: &CheckReport) -> Option<String> {
    let omitted = report.omitted();
    let count = omitted.iter().map(|(_, count)| count).sum::<usize>();
    let rules: Vec<String> =
        omitted.iter().take(LISTED_RULES).map(|(code, count)| format!("{code}: {count}")).collect();
    let more = if omitted.len() > LISTED_RULES { ", …" } else { "" };
    (count > 0).then(|| format!("{} ({}{more}) beyond --max-findings", number(count, "finding"), rules.join(", ")))
}

/// Number of findings that were fixed or can be fixed.
fn fixes(report: &CheckReport) -> Option<String> {
    if let Some(fixed) = report.fixed {
        let all = number(fixed + report.all().count(), "finding");
        return Some(format!("{} of {all} fixed{}", grouped(fixed), refused(report.refused)));
    }
    if let Some(silenced) = report.newly_silenced {
        return Some(format!("{} silenced by new comments", number(silenced, "finding")));
    }
    match (report.fixable(true), report.fixable(false)) {
        (0, 0) => None,
        (0, guesses) => Some(format!("{} may be fixed by --fix --unsafe-fixes", grouped(guesses))),
        (safe, 0) => Some(format!("{} can be fixed by --fix", grouped(safe))),
        (safe, guesses) => {
            let (safe, guesses) = (grouped(safe), grouped(guesses));
            Some(format!("{safe} can be fixed by --fix, {guesses} more may be fixed by --unsafe-fixes"))
        }
    }
}

/// Number of fixes that were omitted because they would have added errors.
fn refused(count: usize) -> String {
    match count {
        0 => String::new(),
        1 => ", 1 fix omitted because it would add an error".to_owned(),
        _ => format!(", {} fixes omitted because they would add errors", grouped(count)),
    }
}

/// Code of the first finding with the highest level.
fn most_serious(report: &CheckReport) -> Option<&'static str> {
    let levels = [FindingSeverity::Error, FindingSeverity::Warning, FindingSeverity::Info];
    let first = |level| report.all().find(|finding| finding.severity == level);
    levels.into_iter().find_map(first).map(|finding| finding.code)
}

fn counts(report: &CheckReport) -> String {
    let statistics = &report.statistics;
    format!(
        "{} {} ({}, {}, {:.2} s)",
        findings(report),
        files(report),
        number(statistics.applications, "application"),
        number(statistics.code_lines, "code line"),
        statistics.seconds
    )
}

fn findings(report: &CheckReport) -> String {
    let levels =
        [(FindingSeverity::Error, "error"), (FindingSeverity::Warning, "warning"), (FindingSeverity::Info, "info")];
    let counted = levels.map(|(level, word)| (report.count(level), word));
    let words: Vec<_> =
        counted.iter().filter(|(count, _)| *count > 0).map(|(count, word)| number(*count, word)).collect();
    match (words.is_empty(), report.baseline.known) {
        (false, _) => words.join(", "),
        (true, _) if !report.is_complete() => "incomplete: no findings".to_owned(),
        (true, 0) => "no findings".to_owned(),
        (true, _) => "no new findings".to_owned(),
    }
}

fn files(report: &CheckReport) -> String {
    let all = number(report.statistics.files, "file");
    match report.faulty_files() {
        0 => format!("in {all}"),
        faulty => format!("in {faulty} of {all}"),
    }
}

/// For example `1 file`, `2 files` or `1,412 files`.
fn number(count: usize, word: &str) -> String {
    let plural = if count == 1 { "" } else { "s" };
    format!("{} {word}{plural}", grouped(count))
}

fn grouped(count: usize) -> String {
    let digits = count.to_string();
    let mut text = String::new();
    for (place, digit) in digits.chars().enumerate() {
        if place > 0 && (digits.len() - place).is_multiple_of(3) {
            text.push(',');
        }
        text.push(digit);
    }
    text
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::report::sample;

    fn summary(report: &CheckReport) -> String {
        let mut out = Vec::new();
        write(report, &mut out).unwrap();
        String::from_utf8(out).unwrap()
    }

    #[test]
    fn findings_are_counted_by_level() {
        insta::assert_snapshot!(summary(&sample::report()), @r"
        More about a finding: val3 explain V0203
        1 error, 1 warning, 1 info in 2 of 3 files (1 application, 1,412 code lines, 0.02 s)
        1 may be fixed by --fix --unsafe-fixes
        ");
    }

    #[test]
    fn fixed_and_remaining_findings_are_counted() {
        let report = CheckReport { fixed: Some(2), ..sample::report() };
        assert!(summary(&report).ends_with("\n2 of 5 findings fixed\n"));
        let report = CheckReport { fixed: Some(0), ..sample::clean() };
        assert!(summary(&report).ends_with("\n0 of 0 findings fixed\n"));
    }

    #[test]
    fn fixes_that_are_left_out_are_counted() {
        let report = CheckReport { fixed: Some(2), refused: 1, ..sample::clean() };
        assert!(summary(&report).ends_with("\n2 of 2 findings fixed, 1 fix omitted because it would add an error\n"));
        let report = CheckReport { fixed: Some(0), refused: 2, ..sample::clean() };
        assert!(summary(&report).ends_with(", 2 fixes omitted because they would add errors\n"));
    }

    #[test]
    fn a_repeated_check_names_the_differences() {
        let report = CheckReport { changes: Some(ReportChanges { new: 2, gone: 0 }), ..sample::report() };
        assert!(summary(&report).contains("\nsince the last check: 2 new, 0 removed\n"));
    }

    #[test]
    fn a_run_names_what_its_check_found() {
        assert_eq!(of_checked_run(&sample::clean()), "the check has no findings in 3 files");
        let found = of_checked_run(&sample::report());
        assert_eq!(found, "the check has 1 error, 1 warning, 1 info in 2 of 3 files; `val3 check` shows them");
    }

    #[test]
    fn a_check_without_findings_has_a_summary() {
        insta::assert_snapshot!(summary(&sample::clean()), @"no findings in 3 files (1 application, 1,412 code lines, 0.02 s)");
    }

    #[test]
    fn excluded_programs_are_mentioned() {
        let written = vec![("val3-baseline.json".to_owned(), 1204)];
        let baseline = BaselineResult { known: 1204, gone: 1, written };
        insta::assert_snapshot!(summary(&CheckReport { silenced: 2, baseline, ..sample::clean() }), @r"
        no new findings in 3 files (1 application, 1,412 code lines, 0.02 s)
        not shown: 1,204 known from the baseline, 2 silenced by comments
        no longer found: 1 known finding; --prune-baseline removes them from the baseline
        wrote val3-baseline.json with 1,204 known findings
        ");
    }

    #[test]
    fn thousands_are_grouped() {
        assert_eq!([0, 999, 1_000, 1_234_567].map(grouped), ["0", "999", "1,000", "1,234,567"]);
    }
}
