//! `help` (5.10): explains a run-time error in the language of the controller.

use crate::call::Call;
use crate::declare::instruction;
use crate::runtime_errors::{self, TaskStatusCode};
use crate::values::Text;
use crate::values::numbers;

instruction! {
    /// Explains a run-time error in the language of the controller.
    ///
    /// - `nErrorCode`: the number, as `taskStatus` returns it.
    /// - Result: the explanation.
    ///
    /// ## Example
    /// ```val3
    /// num nStatus
    ///   nStatus=taskStatus("robot")
    ///   if nStatus>1
    ///     popUpMsg(help(nStatus))
    ///   endIf
    /// ```
    "help": Tasks "5.10";
    function (num nErrorCode) -> string = help;
}

/// Returns the text in English, the only language of the virtual controller; empty for a number that is not in 12.1.
fn help(_: &mut Call<'_>, number: f64) -> Text {
    let number = numbers::round(number) as i64;
    let states = [TaskStatusCode::Absent, TaskStatusCode::Halted, TaskStatusCode::Running];
    let state = states.into_iter().find(|state| i64::from(state.number()) == number).map(TaskStatusCode::meaning);
    let error = || u16::try_from(number).ok().and_then(runtime_errors::find).map(|error| error.short);
    state.or_else(error).map(Text::from).unwrap_or_default()
}

#[cfg(test)]
mod tests {
    use crate::testing::check;

    #[test]
    fn explains_what_task_status_gives() {
        check("help(-1)", "\"no task of this name\"");
        check("help(0)", "\"task suspended\"");
        check("help(1)", "\"task running\"");
        check("help(10)", "\"division by zero\"");
        check("help(250)", "\"licence missing or trial over\"");
        for unknown in ["help(-2)", "help(12)", "help(1e300)"] {
            check(unknown, "\"\"");
        }
    }

    #[test]
    fn every_explanation_fits_a_string() {
        use crate::{runtime_errors::RUNTIME_ERRORS, values::Text};
        assert!(RUNTIME_ERRORS.iter().all(|error| error.short.len() <= Text::CAPACITY));
    }
}
