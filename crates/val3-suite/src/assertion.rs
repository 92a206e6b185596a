//! Message of a failed assertion, created from the arguments in its stack frame. The message in the event log is a
//! string, which is cut at 128 bytes.

mod numbers;
mod positions;
mod strings;

use val3_debug::{FrameArgument, arguments, frames, string_of_data};
use val3_lang::ports::TaskNumber;
use val3_lang::types::BaseType;
use val3_lang::values::printed;
use val3_machine::controller::Controller;

use crate::failure::Failure;
use crate::library::NAME;
use crate::unfinished::places;

/// Data of the library with the text that precedes failures.
const ABOUT: &str = "sAbout";

/// Failure of a task's current assertion. `logged` is its message in the event log.
pub(crate) fn failed_assertion(logged: String, task: Option<TaskNumber>, controller: &Controller) -> Failure {
    // The logged message already contains the text of `about`.
    let message = task.and_then(|task| message(controller, task)).unwrap_or(logged);
    Failure { message, places: task.map(|task| places(controller, task)).unwrap_or_default() }
}

/// Message of a task's current assertion; `None` outside of assertions, or if its parameters are unknown.
fn message(controller: &Controller, task: TaskNumber) -> Option<String> {
    let programs = frames(&controller.vm, task).into_iter().take_while(|frame| frame.application == NAME);
    let programs: Vec<_> = programs.zip(0..).collect();
    let instance = programs.first().map(|(frame, _)| frame.instance)?;
    let about = string_of_data(controller, instance, ABOUT).filter(|text| !text.is_empty());
    let programs: Vec<_> = programs.into_iter().map(|(frame, depth)| (frame.program, depth)).collect();
    let of = |(program, depth): &(String, usize)| worded(program, &arguments(&controller.vm, task, *depth));
    // The innermost program is `fail`, whose text is the fallback.
    let message = programs.iter().skip(1).find_map(of).or_else(|| programs.first().and_then(of))?;
    Some(about.map_or_else(|| message.clone(), |about| format!("{about}: {message}")))
}

/// Message for a program of the library.
fn worded(program: &str, arguments: &[FrameArgument]) -> Option<String> {
    match (program, arguments) {
        ("fail", [text]) => Some(text.text.clone()),
        ("isTrue", [_, text]) => Some(format!("{} is false", text.text)),
        ("equalNum", [actual, expected, tolerance]) => {
            Some(numbers::difference(number(actual)?, number(expected)?, number(tolerance)?))
        }
        ("contains", [text, part]) => {
            Some(format!("{} does not contain {}", printed::string(&text.text), printed::string(&part.text)))
        }
        ("notEqualString", [actual, _]) => Some(format!("not expected: {}", printed::string(&actual.text))),
        ("equalString", [actual, expected]) if actual.base == BaseType::String => {
            Some(strings::difference(&actual.text, &expected.text))
        }
        ("equalJoint", [actual, expected, tolerance]) if actual.base == BaseType::Joint => {
            positions::joints(actual.arm, &actual.nums, &expected.nums, number(tolerance)?)
        }
        ("equalTrsf", [actual, expected, millimetres, degrees]) => {
            positions::poses(&actual.nums, &expected.nums, number(millimetres)?, number(degrees)?)
        }
        _ => None,
    }
}

fn number(argument: &FrameArgument) -> Option<f64> {
    argument.nums.first().copied().filter(|_| argument.base == BaseType::Num)
}
