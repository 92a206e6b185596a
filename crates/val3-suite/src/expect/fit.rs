//! Validation of expectations against the application, before it runs.

use std::ops::Range;

use val3_lang::ports::Time;
use val3_lang::runtime_errors;
use val3_machine::controller::Controller;
use val3_machine::script::{Condition, Seconds};

/// An expectation that can never be met because of names or times: its source range and the problem.
pub(crate) type ExpectationFault = (Range<usize>, String);

/// Run against which expectations are validated.
pub(crate) struct Fit<'c> {
    pub(crate) controller: &'c Controller,
    /// Whether a data item changes its size.
    pub(crate) is_resized: &'c dyn Fn(&str) -> bool,
    /// End time of the run.
    pub(crate) until: Option<Time>,
}

impl Fit<'_> {
    pub(super) fn condition(&self, condition: &Condition, span: &Range<usize>) -> Vec<ExpectationFault> {
        let misfits = self.controller.condition_faults(condition, self.is_resized);
        misfits.iter().map(|misfit| (span.clone(), misfit.with_proposals())).collect()
    }

    pub(super) fn time(&self, time: Seconds, span: &Range<usize>) -> Option<ExpectationFault> {
        let is_late = self.until.is_some_and(|until| time.time() > until);
        is_late.then(|| (span.clone(), format!("{} s is after the end of the run, `until`", time.seconds())))
    }

    pub(super) fn error(&self, code: u16, span: &Range<usize>) -> Option<ExpectationFault> {
        let is_known = runtime_errors::find(code).is_some();
        (!is_known).then(|| (span.clone(), format!("there is no run-time error {code}")))
    }

    pub(crate) fn program(&self, name: &str, span: &Range<usize>) -> Option<ExpectationFault> {
        self.controller.program_misfit(name).map(|misfit| (span.clone(), misfit.with_proposals()))
    }

    pub(super) fn line(&self, link: &str, span: &Range<usize>) -> Option<ExpectationFault> {
        self.controller.line_misfit(link).map(|misfit| (span.clone(), misfit.with_proposals()))
    }
}
