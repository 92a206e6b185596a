//! Evaluation of compiled code in the frames of tasks.

use val3_bytecode::Fragment;
use val3_machine::controller::Controller;
use val3_machine::event::Event;
use val3_vm::{FragmentContext, FragmentEnd};

use crate::values::{self, Format, Value};

/// Executes a fragment, at most `lines` lines of it, without a turn of any task. Returns the value of an expression, whose
/// name is `text`, and the events of the fragment.
pub fn evaluate(
    controller: &mut Controller,
    (fragment, text): (&Fragment, &str),
    context: FragmentContext,
    (lines, format): (u32, Format),
) -> (FragmentEnd<Value>, Vec<Event>) {
    let names = values::names(&controller.vm, context);
    let (end, events) = controller.evaluate(fragment, context, lines, |memory, devices, argument| {
        values::evaluated((memory, devices), (&names, context), (argument, fragment), (text, format))
    });
    (end, events)
}
