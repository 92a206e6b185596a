//! The end of a cycle.

use val3_lang::ports::Time;
use val3_machine::controller::Controller;
use val3_machine::event::Event;

/// The end of a cycle, as expectations see it.
#[derive(Clone, Copy)]
pub(crate) struct Cycle<'c> {
    /// When the cycle began, on the controller's clock in nanoseconds.
    pub(crate) start: Time,
    /// The events of the cycle.
    pub(crate) events: &'c [Event],
    /// The controller at its end.
    pub(crate) controller: &'c Controller,
}
