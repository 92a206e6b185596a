//! Executes a test on one controller in virtual time.

use std::ops::ControlFlow;

use val3_lang::ports::{TaskNumber, Time};
use val3_machine::controller::{Controller, RunStatus};
use val3_session::{LineCondition, Pace};

use crate::application;
use crate::case::{TestCase, TestKind};
use crate::expect::CycleState;
use crate::result::TestResult;
use crate::scenario::Scenario;
use crate::stages::{Stages, Transition};
use crate::unfinished::Unfinished;

/// Settings of tests.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct TestSettings {
    /// Timeout of a test's program, on the controller's clock in nanoseconds.
    pub limit: Time,
}

/// Callbacks and settings of the caller.
pub struct Supervision<'s> {
    /// Settings.
    pub settings: TestSettings,
    /// Whether the test may continue; called after each cycle.
    pub may_go_on: &'s dyn Fn() -> bool,
    /// Returns the conditions for which a task waits.
    pub conditions: &'s mut dyn FnMut(&mut Controller, TaskNumber) -> Vec<LineCondition>,
}

/// Executes a test on a controller that has not executed anything, and that follows the script of `scenario`. `None` if
/// `may_go_on` has returned false.
#[must_use]
pub fn execute(
    controller: &mut Controller,
    case: &TestCase,
    scenario: &Scenario,
    mut supervision: Supervision<'_>,
) -> Option<TestResult> {
    match case.kind {
        TestKind::Program => {
            let mut stages = Stages::start(controller, case.clone(), scenario);
            while !stages.is_over() {
                if execute_program(controller, &mut stages, &mut supervision).is_break() {
                    return None;
                }
            }
            Some(stages.result(controller))
        }
        TestKind::Scenario => application::execute(controller, scenario, &mut supervision),
    }
}

/// Executes the current program of a test to its end or to the timeout, and starts the next program. Aborts if
/// `may_go_on` returns false.
fn execute_program(
    controller: &mut Controller,
    stages: &mut Stages,
    supervision: &mut Supervision<'_>,
) -> ControlFlow<()> {
    let limit = supervision.settings.limit;
    let end = controller.now().saturating_add(limit);
    controller.set_limit(Some(end));
    loop {
        let start = controller.now();
        let status = controller.step_tasks();
        let events = controller.devices.take_events();
        stages.see(CycleState { start, events: &events, controller });
        if stages.follow(controller) != Transition::None {
            return ControlFlow::Continue(());
        }
        if !(supervision.may_go_on)() {
            return ControlFlow::Break(());
        }
        let waits = wait(controller, status, stages.next_due(), end);
        if !waits || controller.now() >= end {
            stages.give_up(controller, Unfinished { limit, has_time: waits }, supervision.conditions);
            stages.follow(controller);
            return ControlFlow::Continue(());
        }
    }
}

/// Advances the clock after a cycle until something can happen, a cycle is due, or the run ends. Returns whether
/// anything can still happen.
pub(crate) fn wait(controller: &mut Controller, status: RunStatus, due: Option<Time>, end: Time) -> bool {
    let pace = Pace { until: due.into_iter().chain([end]).min(), ..Pace::default() };
    match status {
        RunStatus::Waiting(wake) => pace.wait(controller, wake).is_some(),
        RunStatus::Stuck => pace.wait_for_operator(controller).is_some(),
        _ => true,
    }
}
