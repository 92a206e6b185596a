//! Marks findings that are new since the last round of `val3 check --watch`.

use val3_check::baseline::Baseline;
use val3_check::fingerprint::Fingerprint;

use crate::report::{CheckReport, ReportChanges};

/// Findings of the last round.
#[derive(Debug, Default)]
pub(crate) struct History {
    last: Option<Baseline>,
}

impl History {
    /// Marks the findings that the last round did not have, and stores the findings of this round. In the first round,
    /// no finding is new.
    pub(crate) fn mark(&mut self, report: &mut CheckReport) {
        let found: Vec<Fingerprint> = report.findings.iter().map(|finding| finding.fingerprint.clone()).collect();
        if let Some(last) = &self.last {
            let verdict = last.compare(&found, |_| false);
            for (finding, is_new) in report.findings.iter_mut().zip(&verdict.new) {
                finding.is_new = *is_new;
            }
            let new = verdict.new.iter().filter(|is_new| **is_new).count();
            report.changes = Some(ReportChanges { new, gone: verdict.gone.count() });
        }
        let mut last = Baseline::default();
        last.extend(found);
        self.last = Some(last);
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::report::sample;

    #[test]
    fn findings_that_the_last_round_lacked_are_new() {
        let mut history = History::default();
        let mut first = sample::report();
        first.findings.truncate(1);
        history.mark(&mut first);
        assert_eq!((first.findings[0].is_new, first.changes), (false, None));
        let mut second = sample::report();
        history.mark(&mut second);
        let new: Vec<_> = second.findings.iter().map(|finding| finding.is_new).collect();
        assert_eq!((new, second.changes), (vec![false, true, true], Some(ReportChanges { new: 2, gone: 0 })));
        let mut third = sample::clean();
        history.mark(&mut third);
        assert_eq!(third.changes, Some(ReportChanges { new: 0, gone: 3 }));
    }
}
