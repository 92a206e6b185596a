//! A cycle of the controller, as input for expectations.

use val3_lang::ports::Time;
use val3_machine::controller::Controller;
use val3_machine::event::Event;

/// State at the end of a cycle.
#[derive(Clone, Copy)]
pub(crate) struct CycleState<'c> {
    /// Start of the cycle, on the controller's clock in nanoseconds.
    pub(crate) start: Time,
    /// Events of the cycle.
    pub(crate) events: &'c [Event],
    /// Controller at the end of the cycle.
    pub(crate) controller: &'c Controller,
}
