//! The message of a failed assertion, from the arguments in its frame. The message in the event log is a VAL 3 string, which
//! ends after 128 bytes.

mod numbers;
mod positions;
mod strings;

use val3_debug::{FrameArgument, arguments, frames};
use val3_lang::ports::TaskNumber;
use val3_lang::types::BaseType;
use val3_machine::controller::Controller;

use crate::library::NAME;
use crate::result::Failure;
use crate::unfinished::places;

/// The failure of the assertion that a task is in. `logged` is its message in the event log.
pub(crate) fn failed_assertion(logged: String, task: Option<TaskNumber>, controller: &Controller) -> Failure {
    let message = task.and_then(|task| message(controller, task)).unwrap_or(logged);
    Failure { message, places: task.map(|task| places(controller, task)).unwrap_or_default() }
}

/// The message of the assertion that a task is in; `None` if it is in none, or in one with other parameters.
fn message(controller: &Controller, task: TaskNumber) -> Option<String> {
    let programs = frames(&controller.vm, task).into_iter().take_while(|frame| frame.application == NAME);
    let programs: Vec<_> = programs.map(|frame| frame.program).zip(0..).collect();
    let of = |(program, depth): &(String, usize)| worded(program, &arguments(&controller.vm, task, *depth));
    // The program `fail` is the innermost one, and its text the fallback.
    programs.iter().skip(1).find_map(of).or_else(|| programs.first().and_then(of))
}

/// The message of one of the programs of the library.
fn worded(program: &str, arguments: &[FrameArgument]) -> Option<String> {
    match (program, arguments) {
        ("fail", [text]) => Some(text.text.clone()),
        ("isTrue", [_, text]) => Some(format!("{} is false", text.text)),
        ("equalNum", [actual, expected, tolerance]) => {
            Some(numbers::difference(number(actual)?, number(expected)?, number(tolerance)?))
        }
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
