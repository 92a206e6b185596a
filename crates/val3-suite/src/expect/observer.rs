//! Observes the expectations of a test during its execution.

use toml::Spanned;
use val3_lang::ports::Time;
use val3_machine::controller::Controller;
use val3_machine::event::Event;

use super::Expectations;
use super::clearance::ClearanceState;
use super::cycle_time::Stopwatch;
use super::errors::ExpectedErrors;
use super::motion::MotionExpectation;
use super::occurrence::CycleState;
use super::order::OrderState;
use super::output::{ExpectedOutput, OutputKind};
use super::screen::lines;
use super::sent::Sent;
use super::state::TimedStates;
use super::within::Deadline;
use crate::failure::Failure;
use crate::golden_text::{GoldenKind, GoldenText};
use crate::recorded::RecordedMotion;
use crate::source::ExpectationSource;
use crate::unfinished::places_of;

/// Expectations of a test during its execution.
pub(crate) struct Observer {
    expectations: Expectations,
    source: ExpectationSource,
    errors: ExpectedErrors,
    outputs: [ExpectedOutput; 3],
    sent: Vec<Sent>,
    states: TimedStates,
    deadlines: Vec<Deadline>,
    orders: Vec<OrderState>,
    stopwatches: Vec<Stopwatch>,
    motion: MotionExpectation,
    clearance: ClearanceState,
    has_moved: bool,
    /// Printed lines, if they are compared with recorded lines.
    prints: Vec<String>,
}

impl Observer {
    pub(crate) fn new(expectations: &Expectations, source: &ExpectationSource) -> Self {
        let Expectations { print, log, popup, sent, errors, at, within, order, time, .. } = expectations;
        let outputs = [(OutputKind::Print, print), (OutputKind::Log, log), (OutputKind::Popup, popup)];
        Self {
            expectations: expectations.clone(),
            source: source.clone(),
            errors: ExpectedErrors::new(errors),
            outputs: outputs.map(|(kind, texts)| ExpectedOutput::new(kind, texts)),
            sent: sent.iter().map(Sent::new).collect(),
            states: TimedStates::new(at),
            deadlines: within.iter().map(Deadline::new).collect(),
            orders: order.iter().map(OrderState::new).collect(),
            stopwatches: time.iter().map(Stopwatch::new).collect(),
            motion: MotionExpectation::default(),
            clearance: ClearanceState::default(),
            has_moved: false,
            prints: Vec::new(),
        }
    }

    /// Processes a finished cycle.
    pub(crate) fn see(&mut self, cycle: CycleState<'_>) {
        self.errors.see(cycle.events, &|task| places_of(cycle.controller, task));
        self.outputs.iter_mut().for_each(|output| output.see(cycle.events));
        self.sent.iter_mut().for_each(|sent| sent.see(cycle.events));
        self.states.see(cycle.controller, &self.source);
        self.deadlines.iter_mut().for_each(|deadline| deadline.see(cycle));
        self.orders.iter_mut().for_each(|order| order.see(cycle));
        self.stopwatches.iter_mut().for_each(|stopwatch| stopwatch.see(cycle));
        self.motion.see(cycle, &self.expectations);
        self.clearance.see(cycle, &self.expectations);
        if self.expectations.print_file.is_some() {
            let texts = cycle.events.iter().filter_map(|event| OutputKind::Print.text(event));
            self.prints.extend(texts.flat_map(str::lines).map(|line| line.trim_end().to_owned()));
        }
        self.has_moved |= !cycle.controller.arm().is_at_rest();
    }

    /// Time of the next cycle that must not be skipped even if nothing happens.
    pub(crate) fn next_due(&self) -> Option<Time> {
        self.states.next_due()
    }

    /// Whether the event's run-time error is expected.
    pub(crate) fn expects(&self, event: &Event) -> bool {
        self.errors.expects(event)
    }

    /// Failures of unexpected run-time errors.
    pub(crate) fn unexpected_errors(&self) -> &[Failure] {
        self.errors.unexpected()
    }

    /// Failures of unmet expectations at the end of the test.
    pub(crate) fn failures(&self, controller: &Controller) -> Vec<Failure> {
        let source = &self.source;
        let script = |message: String| Failure { message, places: Vec::new() };
        let mut failures: Vec<Failure> = controller.script_problems().into_iter().map(script).collect();
        failures.extend(self.errors.missing(source));
        failures.extend(self.states.failures(controller, source));
        failures.extend(self.expectations.last_state().failures(controller, source));
        failures.extend(self.outputs.iter().flat_map(|output| output.failures(source)));
        failures.extend(self.sent.iter().filter_map(|sent| sent.failure(source)));
        failures.extend(self.deadlines.iter().filter_map(|deadline| deadline.failure(controller, source)));
        failures.extend(self.orders.iter().filter_map(|order| order.failure(controller, source)));
        failures.extend(self.stopwatches.iter().filter_map(|stopwatch| stopwatch.failure(controller, source)));
        failures.extend(self.motion.failures(&self.expectations, controller, source));
        failures.extend(self.clearance.failures(&self.expectations, controller, source));
        failures
    }

    /// Texts to compare with recorded texts, at the end of the test.
    pub(crate) fn golden_texts(&self, controller: &Controller) -> Vec<GoldenText> {
        let Expectations { screen_file, print_file, .. } = &self.expectations;
        let screen = screen_file.iter().map(|file| self.golden_text(GoldenKind::Screen, file, lines(controller)));
        let prints = print_file.iter().map(|file| self.golden_text(GoldenKind::Prints, file, self.prints.clone()));
        screen.chain(prints).collect()
    }

    fn golden_text(&self, kind: GoldenKind, file: &Spanned<String>, lines: Vec<String>) -> GoldenText {
        GoldenText { kind, file: file.get_ref().clone(), place: self.source.place(kind.key(), file.span()), lines }
    }

    /// Note on cycle times, if one was compared with a limit and the arm has moved.
    pub(crate) fn times_note(&self, controller: &Controller) -> Option<String> {
        let is_limited = self.has_moved && !self.stopwatches.is_empty();
        is_limited.then(|| controller.arm().model().times_note()).flatten()
    }

    /// Motion to compare with a recorded motion, if expected.
    pub(crate) fn into_motion(self) -> Option<Box<RecordedMotion>> {
        self.motion.recorded(&self.expectations, &self.source)
    }
}
