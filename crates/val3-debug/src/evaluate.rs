//! Evaluation of compiled code in stack frames.

use val3_lang::fault::Fault;
use val3_lang::runtime_errors;
use val3_machine::controller::Controller;
use val3_machine::event::Event;
use val3_vm::{FragmentContext, FragmentEnd};

use crate::values::{self, DebugValue, DisplayFormat, NamedFragment};

/// Number of lines that an expression may execute.
const LINES: u32 = 1000;

/// Returns the grant for an expression: a fixed number of lines.
pub fn expression_grant() -> impl Iterator<Item = u32> {
    std::iter::once(LINES)
}

/// Executes a fragment, without a turn of any task, until it ends or has executed the granted lines. Returns its value
/// and its events.
pub fn evaluate(
    controller: &mut Controller,
    code: NamedFragment<'_>,
    context: FragmentContext,
    grants: &mut dyn Iterator<Item = u32>,
    format: DisplayFormat,
) -> (FragmentEnd<DebugValue>, Vec<Event>) {
    let names = values::names(&controller.vm, context);
    let (end, events) = controller.evaluate(code.fragment, context, grants, |memory, devices, argument| {
        values::evaluated(memory, devices, &names, context, argument, code, format)
    });
    (end, events)
}

/// Returns the reason why a fragment did not end normally, for users.
#[must_use]
pub fn end_message<T>(end: &FragmentEnd<T>) -> String {
    match end {
        FragmentEnd::Failed(Fault(code)) => {
            let meaning = runtime_errors::find(*code).map_or("unknown", |error| error.short);
            format!("error {code}: {meaning}")
        }
        FragmentEnd::Waiting => "it waits for an event that cannot happen while the run is stopped".to_owned(),
        FragmentEnd::Limit => "it was ended because it executes too many lines, probably in an endless loop".to_owned(),
        FragmentEnd::Interrupted => "it was interrupted, or it has printed too much".to_owned(),
        FragmentEnd::Unsupported => "it uses an instruction that this controller does not have".to_owned(),
        FragmentEnd::AtStop => "it has stopped at a breakpoint".to_owned(),
        FragmentEnd::Gone => "the stack frame no longer exists".to_owned(),
        FragmentEnd::Value(_) | FragmentEnd::Done => String::new(),
    }
}
